//! Mutations of a file: bytes, lines and numbers changed, removed, repeated or taken from another file.

use ffrf_test_kit::random::Random;

/// Pieces that readers have to look at twice.
const PIECES: [&[u8]; 30] = [
    b"4000000000",
    b"18446744073709551615",
    b"-1",
    b"0",
    b"1e36",
    b"1e400",
    b"nan",
    b"-inf",
    b"5e-324",
    b"1.7976931348623157e308",
    b"0x10",
    b",",
    b",,",
    b"\n",
    b"\r\n",
    b"\t",
    b" ",
    b"%%MatrixMarket matrix coordinate real symmetric\n",
    b"%",
    b"*NODE\n",
    b"*INSTANCE, NAME=a, PART=p\n*END INSTANCE\n",
    b"*NSET, NSET=s, GENERATE\n1, 18446744073709551615, 1\n",
    b"*INCLUDE, INPUT=part.inp\n",
    b"\x1b[2J",
    b"\0",
    b"\xff\xff\xff\xff",
    b"{",
    b"[[[[[[[[[[[[[[[[",
    b"null",
    b"\"",
];

/// One to four mutations of a sample, some of which take a piece of another.
pub fn mutate(sample: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = sample.to_vec();
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + 1 + random.below(12)).min(bytes.len());
        match random.below(10) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => {
                let again = bytes[at..end].to_vec();
                bytes.splice(at..at, again);
            }
            3 => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
            4 => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte = random.below(256) as u8;
                }
            }
            5 => drop(bytes.splice(at..at, PIECES[random.below(PIECES.len())].iter().copied())),
            6 => replace_token(&mut bytes, at, PIECES[random.below(PIECES.len())]),
            7 => remove_line(&mut bytes, at),
            8 => repeat_line(&mut bytes, at),
            _ => {
                let from = random.below(other.len() + 1);
                let to = (from + random.below(80)).min(other.len());
                bytes.splice(at..end, other[from..to].iter().copied());
            }
        }
    }
    bytes
}

/// The bounds of what stands between separators around a place.
fn around(bytes: &[u8], at: usize, is_separator: impl Fn(u8) -> bool) -> (usize, usize) {
    let at = at.min(bytes.len());
    let start = bytes[..at].iter().rposition(|&byte| is_separator(byte)).map_or(0, |before| before + 1);
    let end = bytes[at..].iter().position(|&byte| is_separator(byte)).map_or(bytes.len(), |after| at + after);
    (start, end)
}

fn replace_token(bytes: &mut Vec<u8>, at: usize, piece: &[u8]) {
    let (start, end) = around(bytes, at, |byte| b" ,\t\n\r()[]{}:".contains(&byte));
    bytes.splice(start..end, piece.iter().copied());
}

fn remove_line(bytes: &mut Vec<u8>, at: usize) {
    let (start, end) = around(bytes, at, |byte| byte == b'\n');
    bytes.drain(start..(end + 1).min(bytes.len()));
}

fn repeat_line(bytes: &mut Vec<u8>, at: usize) {
    let (start, end) = around(bytes, at, |byte| byte == b'\n');
    let mut line = bytes[start..end].to_vec();
    line.push(b'\n');
    bytes.splice(start..start, line);
}
