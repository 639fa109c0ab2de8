//! Prints the lines that this machine makes.

fn main() {
    print!("{}", raystep_wasm::lines());
}
