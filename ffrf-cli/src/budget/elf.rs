//! What a linked program for a 32-bit target holds: its sections and its functions (ELF, little-endian).

use anyhow::{Context, Result, bail};

/// Sizes of what a program puts into memory. Units: bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sizes {
    /// Machine code, with the constants that stand between its functions.
    pub code: u64,
    /// Constants that the program reads from tables.
    pub tables: u64,
    /// Variables, those with a first value and those without.
    pub variables: u64,
}

/// A function of the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Function {
    /// Its symbol.
    pub name: String,
    /// Address of its first instruction.
    pub address: u32,
    /// Length. Units: bytes.
    pub size: u32,
}

/// A linked program.
#[derive(Debug)]
pub struct Program {
    /// Sizes of its sections.
    pub sizes: Sizes,
    /// Its functions, by address.
    pub functions: Vec<Function>,
    /// Where data (`true`) or code (`false`) begins within the code, by address.
    pub data_begins: Vec<(u32, bool)>,
    /// Address and bytes of each section with code.
    code: Vec<(u32, Vec<u8>)>,
    /// The bytes of each section with constants or variables.
    data: Vec<Vec<u8>>,
}

struct Section {
    name: String,
    kind: u32,
    flags: u32,
    address: u32,
    bytes: Option<Vec<u8>>,
    size: u32,
    link: u32,
}

const SYMBOLS: u32 = 2;
const NO_BITS: u32 = 8;
const WRITABLE: u32 = 1;
const ALLOCATED: u32 = 2;
const EXECUTABLE: u32 = 4;

impl Program {
    /// Reads the bytes of a program. Errors: they are no such program.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        if bytes.get(..6) != Some(b"\x7fELF\x01\x01") {
            bail!("expected a 32-bit little-endian ELF program");
        }
        let sections = sections(bytes).context("the table of sections is cut short")?;
        let mut sizes = Sizes::default();
        let (mut code, mut data) = (Vec::new(), Vec::new());
        for section in sections.iter().filter(|section| section.flags & ALLOCATED != 0) {
            let size = u64::from(section.size);
            if section.flags & EXECUTABLE != 0 {
                sizes.code += size;
                code.push((section.address, section.bytes.clone().unwrap_or_default()));
            } else if section.flags & WRITABLE != 0 {
                sizes.variables += size;
            } else if section.name != ".vector_table" {
                sizes.tables += size;
            }
            if section.flags & EXECUTABLE == 0 && section.name != ".vector_table" {
                data.push(section.bytes.clone().unwrap_or_default());
            }
        }
        let (mut functions, data_begins) = symbols(&sections).context("the table of symbols is cut short")?;
        functions.sort_by_key(|function: &Function| (function.address, std::cmp::Reverse(function.size)));
        functions.dedup_by_key(|function| function.address);
        // functions in assembly may not say how long they are: they end where the next begins
        for place in 0..functions.len() {
            let next = functions.get(place + 1).map_or(functions[place].address, |next| next.address);
            let function = &mut functions[place];
            if function.size == 0 {
                function.size = next - function.address;
            }
        }
        Ok(Self { sizes, functions, data_begins, code, data })
    }

    /// The function at this address.
    pub fn function_at(&self, address: u32) -> Option<&Function> {
        let place = self.functions.partition_point(|function| function.address <= address).checked_sub(1)?;
        self.functions.get(place).filter(|function| address < function.address + function.size)
    }

    /// The only function whose symbol holds `part`.
    pub fn function_named(&self, part: &str) -> Option<&Function> {
        self.functions.iter().find(|function| function.name.contains(part))
    }

    /// The functions whose address stands in constants or variables, or between functions: what a call through a
    /// register can reach, besides addresses that the code makes.
    pub fn addressed(&self) -> Vec<&Function> {
        let words = |bytes: &[u8]| -> Vec<u32> {
            bytes.chunks_exact(4).filter_map(|word| Some(u32::from_le_bytes(word.try_into().ok()?))).collect()
        };
        let mut addresses: Vec<u32> = self.data.iter().flat_map(|bytes| words(bytes)).collect();
        addresses.extend(self.code.iter().flat_map(|(_, bytes)| words(bytes)));
        addresses.sort_unstable();
        // the lowest bit of a pointer says that the code is Thumb
        self.functions
            .iter()
            .filter(|function| addresses.binary_search(&(function.address | 1)).is_ok())
            .collect()
    }

    /// The 16-bit unit of code at `address`.
    pub fn halfword(&self, address: u32) -> Option<u16> {
        self.code.iter().find_map(|(start, bytes)| {
            let offset = address.checked_sub(*start)? as usize;
            Some(u16::from_le_bytes(bytes.get(offset..offset + 2)?.try_into().ok()?))
        })
    }
}

fn word(bytes: &[u8], offset: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(offset..offset.checked_add(4)?)?.try_into().ok()?))
}

fn half(bytes: &[u8], offset: usize) -> Option<usize> {
    Some(usize::from(u16::from_le_bytes(bytes.get(offset..offset + 2)?.try_into().ok()?)))
}

/// The text from `offset` up to a zero byte.
fn name(bytes: &[u8], offset: u32) -> Option<String> {
    let rest = bytes.get(offset as usize..)?;
    Some(rest.iter().take_while(|byte| **byte != 0).map(|byte| char::from(*byte)).collect())
}

fn sections(bytes: &[u8]) -> Option<Vec<Section>> {
    let table = word(bytes, 0x20)? as usize;
    let (size, count, names) = (half(bytes, 0x2e)?, half(bytes, 0x30)?, half(bytes, 0x32)?);
    let header = |number: usize| table + number * size;
    let names_offset = word(bytes, header(names) + 0x10)? as usize;
    (0..count)
        .map(|number| {
            let at = |field: usize| word(bytes, header(number) + field);
            let (kind, offset, size) = (at(4)?, at(0x10)? as usize, at(0x14)?);
            let content = bytes.get(offset..offset.checked_add(size as usize)?);
            Some(Section {
                name: name(bytes.get(names_offset..)?, at(0)?)?,
                kind,
                flags: at(8)?,
                address: at(0xc)?,
                bytes: if kind == NO_BITS { None } else { Some(content?.to_vec()) },
                size,
                link: at(0x18)?,
            })
        })
        .collect()
}

/// Where data ($d of the ABI, true) or code ($t) begins.
type Mark = (u32, bool);

/// Functions, and where data and code begin.
fn symbols(sections: &[Section]) -> Option<(Vec<Function>, Vec<Mark>)> {
    const ENTRY: usize = 16;
    const FUNCTION: u8 = 2;
    let (mut functions, mut data_begins) = (Vec::new(), Vec::new());
    for table in sections.iter().filter(|section| section.kind == SYMBOLS) {
        let names = sections.get(table.link as usize)?.bytes.as_deref()?;
        for entry in table.bytes.as_deref()?.chunks_exact(ENTRY) {
            let (name, value, size) = (name(names, word(entry, 0)?)?, word(entry, 4)?, word(entry, 8)?);
            let defined = half(entry, 14)? != 0;
            if entry[12] & 15 == FUNCTION && defined {
                // the lowest bit says that the code is Thumb
                functions.push(Function { name, address: value & !1, size });
            } else if name.starts_with("$d") {
                data_begins.push((value, true));
            } else if name.starts_with("$t") {
                data_begins.push((value, false));
            }
        }
    }
    data_begins.sort_unstable();
    Some((functions, data_begins))
}
