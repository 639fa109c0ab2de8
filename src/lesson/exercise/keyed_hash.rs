//! A hash with a key: who knows some of its values cannot compute others.

/// SipHash-2-4, after J.-P. Aumasson and D. J. Bernstein, *SipHash: a fast short-input PRF* (2012).
pub(super) fn keyed_hash(key: [u64; 2], bytes: &[u8]) -> u64 {
    // "somepseudorandomlygeneratedbytes", as the paper has it
    let mut v = [
        key[0] ^ 0x736f_6d65_7073_6575,
        key[1] ^ 0x646f_7261_6e64_6f6d,
        key[0] ^ 0x6c79_6765_6e65_7261,
        key[1] ^ 0x7465_6462_7974_6573,
    ];
    let mut words = bytes.chunks_exact(8);
    let word = |bytes: &[u8]| {
        let mut padded = [0; 8];
        padded[..bytes.len()].copy_from_slice(bytes);
        u64::from_le_bytes(padded)
    };
    for bytes in &mut words {
        add(&mut v, word(bytes));
    }
    // the rest, and the length in the highest byte
    let last = word(words.remainder()) | (bytes.len() as u64) << 56;
    add(&mut v, last);
    v[2] ^= 0xff;
    (0..4).for_each(|_| round(&mut v));
    v[0] ^ v[1] ^ v[2] ^ v[3]
}

fn add(v: &mut [u64; 4], word: u64) {
    v[3] ^= word;
    round(v);
    round(v);
    v[0] ^= word;
}

fn round(v: &mut [u64; 4]) {
    v[0] = v[0].wrapping_add(v[1]);
    v[2] = v[2].wrapping_add(v[3]);
    v[1] = v[1].rotate_left(13) ^ v[0];
    v[3] = v[3].rotate_left(16) ^ v[2];
    v[0] = v[0].rotate_left(32);
    v[2] = v[2].wrapping_add(v[1]);
    v[0] = v[0].wrapping_add(v[3]);
    v[1] = v[1].rotate_left(17) ^ v[2];
    v[3] = v[3].rotate_left(21) ^ v[0];
    v[2] = v[2].rotate_left(32);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The key of the paper: bytes 0 to 15.
    const KEY: [u64; 2] = [0x0706_0504_0302_0100, 0x0f0e_0d0c_0b0a_0908];

    #[test]
    fn it_gives_the_values_of_the_paper() {
        let bytes: Vec<u8> = (0..15).collect();
        // appendix A
        assert_eq!(keyed_hash(KEY, &bytes), 0xa129_ca61_49be_45e5);
        // the authors' table of vectors, for 0 and 8 bytes
        assert_eq!(keyed_hash(KEY, &[]), 0x726f_db47_dd0e_0e31);
        assert_eq!(keyed_hash(KEY, &bytes[..8]), 0x93f5_f579_9a93_2462);
    }
}
