//! NumPy archives: named arrays in one file.

use std::io::{Cursor, Write as _};

use anyhow::{Context as _, Result};
use npyz::{DType, TypeStr, WriterBuilder as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// An array of an archive.
#[derive(Debug, Clone, PartialEq)]
pub enum Array {
    /// Numbers, the last index fastest.
    Numbers {
        /// Lengths along each axis.
        shape: Vec<usize>,
        /// As many as the shape says.
        values: Vec<f64>,
    },
    /// Texts in one row.
    Texts(Vec<String>),
}

/// The bytes of an archive. The same arrays give the same bytes: no time of day goes in.
///
/// Errors: an array is not as its shape says; nothing else is known to fail in memory.
pub fn archive(arrays: impl IntoIterator<Item = (String, Array)>) -> Result<Vec<u8>> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default());
    for (name, array) in arrays {
        writer.start_file(format!("{name}.npy"), options).with_context(|| name.clone())?;
        writer.write_all(&npy(&array).with_context(|| name.clone())?)?;
    }
    Ok(writer.finish()?.into_inner())
}

fn npy(array: &Array) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    match array {
        Array::Numbers { shape, values } => {
            let shape: Vec<u64> = shape.iter().map(|length| *length as u64).collect();
            let options = npyz::WriteOptions::new().default_dtype().shape(&shape);
            let mut writer = options.writer(&mut bytes).begin_nd()?;
            writer.extend(values)?;
            writer.finish()?;
        }
        Array::Texts(texts) => {
            let longest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
            let kind: TypeStr = format!("<U{longest}").parse()?;
            let options =
                npyz::WriteOptions::new().dtype(DType::new_scalar(kind)).shape(&[texts.len() as u64]);
            let mut writer = options.writer(&mut bytes).begin_nd()?;
            for text in texts {
                writer.push(text.as_str())?;
            }
            writer.finish()?;
        }
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_are_read_back_and_the_same_arrays_give_the_same_bytes() {
        let numbers = Array::Numbers { shape: vec![2, 3], values: vec![1.0, 2.0, 3.0, 4.0, 5.0, -0.1] };
        let texts = Array::Texts(vec!["tip.x".into(), "φ".into()]);
        let arrays = || [("A".to_owned(), numbers.clone()), ("names".to_owned(), texts.clone())];
        let bytes = archive(arrays()).unwrap();
        assert_eq!(bytes, archive(arrays()).unwrap());
        let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        let read = npyz::NpyFile::new(zip.by_name("A.npy").unwrap()).unwrap();
        assert_eq!(read.shape(), [2, 3]);
        assert_eq!(read.into_vec::<f64>().unwrap(), [1.0, 2.0, 3.0, 4.0, 5.0, -0.1]);
        let read = npyz::NpyFile::new(zip.by_name("names.npy").unwrap()).unwrap();
        assert_eq!(read.into_vec::<String>().unwrap(), ["tip.x", "φ"]);
    }

    #[test]
    fn a_shape_that_the_numbers_do_not_fill_is_refused() {
        let short = Array::Numbers { shape: vec![3], values: vec![1.0] };
        archive([("A".to_owned(), short)]).unwrap_err();
    }
}
