//! Builds the book of the browser's tests with mdBook itself: `browser_book RAYSTEP OUT`.

use std::env;
use std::error::Error;
use std::path::{Path, PathBuf};

use mdbook_driver::MDBook;
use mdbook_driver::config::Config;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<PathBuf> = env::args_os().skip(1).map(PathBuf::from).collect();
    let [raystep, out] = arguments.as_slice() else {
        return Err("give the command raystep and the folder for the book".into());
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/browser/book");
    let mut config: Config = "[book]\ntitle = \"Steps\"\nlanguage = \"en\"\n".parse()?;
    config.set("build.build-dir", std::path::absolute(out)?)?;
    let command = format!("'{}' mdbook", std::path::absolute(raystep)?.display());
    config.set("preprocessor.raystep.command", command)?;
    config.set("preprocessor.raystep.lessons", "lessons")?;
    config.set("preprocessor.raystep.allow-outside", true)?;
    MDBook::load_with_config(root, config)?.build()?;
    Ok(())
}
