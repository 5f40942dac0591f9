//! Arrays of VTK's XML files: as text, in base64, or raw behind all tags; deflated in blocks or not.

use std::io::Read;

use flate2::read::ZlibDecoder;

use crate::import::ImportError;
use crate::import::text::cursor::{Cursor, Defect, DefectKind};
use crate::import::text::source::Source;

/// How an array is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    /// Numbers as text.
    Ascii,
    /// Base64 between the tags.
    Binary,
    /// In the appended data.
    Appended,
}

/// What `<DataArray>` says.
pub(super) struct Array<'a> {
    /// The tag around it.
    pub(super) section: String,
    pub(super) name: String,
    /// Where its tag stands.
    pub(super) place: usize,
    pub(super) components: usize,
    pub(super) encoding: Encoding,
    /// What stands between the tags.
    pub(super) text: &'a [u8],
    /// Where that starts in the file.
    pub(super) text_start: usize,
    offset: usize,
    scalar: Scalar,
}

/// A type of number: whether it is an integer, whether it has a sign, and its size in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Scalar {
    is_integer: bool,
    is_signed: bool,
    size: usize,
}

impl Scalar {
    fn of(name: &str) -> Option<Self> {
        let (kind, bits) = name.split_at(name.find(|c: char| c.is_ascii_digit())?);
        let bits: usize = bits.parse().ok()?;
        let (is_integer, is_signed, sizes) = match kind {
            "Int" => (true, true, &[8, 16, 32, 64][..]),
            "UInt" => (true, false, &[8, 16, 32, 64][..]),
            "Float" => (false, true, &[32, 64][..]),
            _ => return None,
        };
        sizes.contains(&bits).then_some(Self { is_integer, is_signed, size: bits / 8 })
    }
}

type Attribute = Result<Option<String>, ImportError>;

impl<'a> Array<'a> {
    pub(super) fn new(
        source: &Source,
        place: usize,
        section: String,
        attribute: impl Fn(&str) -> Attribute,
    ) -> Result<Self, ImportError> {
        let expected = |what: &str| source.expected(place, what);
        let scalar = attribute("type")?.and_then(|name| Scalar::of(&name));
        let encoding = match attribute("format")?.as_deref() {
            Some("ascii") => Encoding::Ascii,
            Some("binary") => Encoding::Binary,
            Some("appended") => Encoding::Appended,
            _ => return Err(expected("a DataArray of format ascii, binary or appended")),
        };
        let number = |text: Option<String>, or: usize| match text {
            None => Some(or),
            Some(text) => text.trim().parse().ok(),
        };
        Ok(Self {
            section,
            name: attribute("Name")?.unwrap_or_default(),
            place,
            components: number(attribute("NumberOfComponents")?, 1)
                .ok_or_else(|| expected("a number as attribute NumberOfComponents"))?,
            encoding,
            text: &[],
            text_start: 0,
            offset: number(attribute("offset")?, 0)
                .ok_or_else(|| expected("a number as attribute offset"))?,
            scalar: scalar
                .ok_or_else(|| expected("a DataArray of type Int8 to UInt64, Float32 or Float64"))?,
        })
    }

    pub(super) fn is_integer(&self) -> bool {
        self.scalar.is_integer
    }

    /// Refuses an array of a wrong length.
    pub(super) fn must_hold(
        &self,
        source: &Source,
        what: &str,
        expected: usize,
        found: usize,
    ) -> Result<(), ImportError> {
        if expected == found {
            return Ok(());
        }
        Err(source.expected(self.place, format!("{expected} {what} as the <Piece> announces, found {found}")))
    }
}

/// What holds for all arrays of a file.
pub(super) struct Container<'a> {
    is_big_endian: bool,
    header: usize,
    is_compressed: bool,
    appended: &'a [u8],
    is_raw: bool,
}

impl<'a> Container<'a> {
    pub(super) fn new(
        source: &Source,
        place: usize,
        attribute: impl Fn(&str) -> Attribute,
    ) -> Result<Self, ImportError> {
        if attribute("type")?.as_deref() != Some("UnstructuredGrid") {
            return Err(source.expected(place, "<VTKFile type=\"UnstructuredGrid\">"));
        }
        let is_compressed = match attribute("compressor")?.as_deref() {
            None | Some("") => false,
            Some("vtkZLibDataCompressor") => true,
            Some(_) => return Err(source.expected(place, "no compressor, or vtkZLibDataCompressor")),
        };
        let header = match attribute("header_type")?.as_deref() {
            None | Some("UInt32") => 4,
            Some("UInt64") => 8,
            Some(_) => return Err(source.expected(place, "a header_type of UInt32 or UInt64")),
        };
        let is_big_endian = attribute("byte_order")?.as_deref() == Some("BigEndian");
        Ok(Self { is_big_endian, header, is_compressed, appended: &[], is_raw: false })
    }

    /// Tells where the appended data are.
    pub(super) fn append(&mut self, bytes: &'a [u8], is_raw: bool) {
        (self.appended, self.is_raw) = (bytes, is_raw);
    }

    /// The finite numbers of an array of floats.
    pub(super) fn floats(&self, source: &Source, array: &Array<'_>) -> Result<Vec<f64>, ImportError> {
        if array.scalar.is_integer {
            return Err(source.expected(array.place, "an array of Float32 or Float64"));
        }
        let values = if array.encoding == Encoding::Ascii {
            ascii(source, array, |cursor| cursor.float("a number"))?
        } else {
            let bytes = self.bytes(source, array)?;
            let number = |bytes: &[u8]| match array.scalar.size {
                4 => f64::from(f32::from_bits(self.unsigned(bytes) as u32)),
                _ => f64::from_bits(self.unsigned(bytes)),
            };
            bytes.chunks_exact(array.scalar.size).map(number).collect()
        };
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(values),
            Some(at) => {
                let found = format!("{} at {at} (from 0)", values[at]);
                Err(source.expected(array.place, format!("finite numbers, found {found}")))
            }
        }
    }

    /// The numbers of an array of integers.
    pub(super) fn integers(&self, source: &Source, array: &Array<'_>) -> Result<Vec<i64>, ImportError> {
        if !array.scalar.is_integer {
            return Err(source.expected(array.place, "an array of integers"));
        }
        if array.encoding == Encoding::Ascii {
            let signed = |cursor: &mut Cursor<'_>| {
                cursor.skip_separators();
                let is_negative = array.text.get(cursor.at) == Some(&b'-');
                cursor.at += usize::from(is_negative);
                let at = cursor.at;
                let value = i64::try_from(cursor.unsigned("an integer")?);
                let value =
                    value.map_err(|_| Defect { at, kind: DefectKind::Expected("a smaller integer") })?;
                Ok(if is_negative { -value } else { value })
            };
            return ascii(source, array, signed);
        }
        let bytes = self.bytes(source, array)?;
        let unused = 64 - 8 * array.scalar.size as u32;
        let number = |bytes: &[u8]| {
            let value = self.unsigned(bytes) as i64;
            if array.scalar.is_signed { value << unused >> unused } else { value }
        };
        Ok(bytes.chunks_exact(array.scalar.size).map(number).collect())
    }

    /// Up to eight bytes as a number, in the order of the file.
    fn unsigned(&self, bytes: &[u8]) -> u64 {
        let add = |sum: u64, &byte: &u8| sum << 8 | u64::from(byte);
        if self.is_big_endian { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) }
    }

    /// The bytes of an array: one block behind its length, or deflated blocks behind their lengths.
    fn bytes(&self, source: &Source, array: &Array<'_>) -> Result<Vec<u8>, ImportError> {
        let cut = || source.expected(array.place, format!("all bytes of the array `{}`", array.name));
        let mut stream = match array.encoding {
            Encoding::Appended => {
                let bytes = self.appended.get(array.offset..).ok_or_else(cut)?;
                Stream { bytes, is_raw: self.is_raw, decoded: Vec::new() }
            }
            _ => Stream { bytes: array.text, is_raw: false, decoded: Vec::new() },
        };
        let number = |stream: &mut Stream<'_>| -> Option<usize> {
            usize::try_from(self.unsigned(&stream.take(self.header)?)).ok()
        };
        let limit = source.inflated_limit();
        let bytes = if self.is_compressed {
            let count = number(&mut stream).ok_or_else(cut)?;
            let _size = number(&mut stream).ok_or_else(cut)?;
            let _last = number(&mut stream).ok_or_else(cut)?;
            let mut sizes = Vec::new();
            for _ in 0..count {
                sizes.push(number(&mut stream).ok_or_else(cut)?);
            }
            let mut bytes = Vec::new();
            for size in sizes {
                let block = stream.take(size).ok_or_else(cut)?;
                let room = (limit + 1).saturating_sub(bytes.len() as u64);
                let inflated = ZlibDecoder::new(block.as_slice()).take(room).read_to_end(&mut bytes);
                inflated.map_err(|error| {
                    let text = format!("deflated blocks of the array `{}` ({error})", array.name);
                    source.expected(array.place, text)
                })?;
                if bytes.len() as u64 > limit {
                    let expected = format!("at most {limit} bytes of the array `{}`", array.name);
                    return Err(source.expected(array.place, expected));
                }
            }
            bytes
        } else {
            let size = number(&mut stream).ok_or_else(cut)?;
            stream.take(size).ok_or_else(cut)?
        };
        if bytes.len() % array.scalar.size == 0 { Ok(bytes) } else { Err(cut()) }
    }
}

/// All numbers of the text of an array.
fn ascii<T>(
    source: &Source,
    array: &Array<'_>,
    read: impl Fn(&mut Cursor<'_>) -> Result<T, Defect>,
) -> Result<Vec<T>, ImportError> {
    let mut cursor = Cursor::new(array.text, 0);
    let mut values = Vec::new();
    loop {
        while cursor.at < array.text.len() && array.text[cursor.at].is_ascii_whitespace() {
            cursor.at += 1;
        }
        if cursor.at >= array.text.len() {
            return Ok(values);
        }
        values.push(read(&mut cursor).map_err(|mut defect| {
            defect.at += array.text_start;
            source.defect(&defect, 0)
        })?);
    }
}

/// Bytes in base64, of which several pieces may follow each other, or raw.
struct Stream<'a> {
    bytes: &'a [u8],
    is_raw: bool,
    /// Decoded and not taken yet.
    decoded: Vec<u8>,
}

impl Stream<'_> {
    /// The next bytes; `None` if there are fewer.
    fn take(&mut self, count: usize) -> Option<Vec<u8>> {
        if self.is_raw {
            let (taken, rest) = self.bytes.split_at_checked(count)?;
            self.bytes = rest;
            return Some(taken.to_vec());
        }
        if count > self.decoded.len() + self.bytes.len() {
            return None;
        }
        while self.decoded.len() < count {
            self.decode_four()?;
        }
        let rest = self.decoded.split_off(count);
        Some(std::mem::replace(&mut self.decoded, rest))
    }

    /// Four characters to one, two or three bytes.
    fn decode_four(&mut self) -> Option<()> {
        let (mut bits, mut count, mut padding) = (0_u32, 0, 0);
        while count < 4 {
            let (&byte, rest) = self.bytes.split_first()?;
            self.bytes = rest;
            let value = match byte {
                _ if padding > 0 && byte != b'=' => return None,
                b'A'..=b'Z' => byte - b'A',
                b'a'..=b'z' => byte - b'a' + 26,
                b'0'..=b'9' => byte - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                b'=' if count >= 2 => {
                    padding += 1;
                    0
                }
                _ if byte.is_ascii_whitespace() => continue,
                _ => return None,
            };
            bits = bits << 6 | u32::from(value);
            count += 1;
        }
        let [_, bytes @ ..] = bits.to_be_bytes();
        self.decoded.extend(bytes.iter().take(3 - padding));
        Some(())
    }
}
