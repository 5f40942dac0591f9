//! The modules of a crate and what they import from each other, read from their text.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Names from the crate root down to a module; empty for the root.
pub type Module = Vec<String>;

/// The source of one crate.
pub struct Crate {
    /// Text of each module, without comments and unit tests.
    texts: BTreeMap<Module, String>,
    /// What a module calls by a name of its own: name, path from the root.
    uses: BTreeMap<Module, Vec<(String, Module)>>,
}

impl Crate {
    /// Reads the crate with that root file.
    pub fn read(root: &Path) -> Self {
        let folder = root.parent().expect("a root file stands in a folder");
        let mut texts = BTreeMap::from([(Module::new(), text(root))]);
        let mut folders = vec![(folder.to_path_buf(), Module::new())];
        while let Some((folder, module)) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("readable folder") {
                let path = entry.expect("readable entry").path();
                let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default().to_owned();
                let child = [module.as_slice(), std::slice::from_ref(&name)].concat();
                if path.is_dir() {
                    folders.push((path, child));
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    match name.as_str() {
                        "mod" => texts.insert(module.clone(), text(&path)),
                        "lib" | "main" if module.is_empty() => None,
                        _ => texts.insert(child, text(&path)),
                    };
                }
            }
        }
        let mut code = Self { texts, uses: BTreeMap::new() };
        let uses = code.texts.iter().map(|(module, text)| (module.clone(), code.names(module, text)));
        code.uses = uses.collect();
        code
    }

    /// Every import: the module that holds it, the module that it reaches into, and the path as it is written.
    pub fn imports(&self) -> Vec<(Module, Module, String)> {
        let mut found = Vec::new();
        for (module, text) in &self.texts {
            for path in paths(text) {
                if let Some(absolute) = self.absolute(module, &path) {
                    found.push((module.clone(), self.home(&absolute, 0), path.join("::")));
                }
            }
        }
        found
    }

    /// The path from the root, if it is a path into this crate.
    fn absolute(&self, module: &[String], path: &[String]) -> Option<Module> {
        let mut base = module.to_vec();
        let mut rest = path;
        match path.first()?.as_str() {
            "crate" => {
                base.clear();
                rest = &path[1..];
            }
            "self" => rest = &path[1..],
            "super" => {
                while let Some((first, later)) = rest.split_first()
                    && first == "super"
                {
                    base.pop();
                    rest = later;
                }
            }
            child => {
                base.push(child.to_owned());
                if !self.texts.contains_key(&base) {
                    return None;
                }
                rest = &path[1..];
            }
        }
        Some([base.as_slice(), rest].concat())
    }

    /// The module in which the thing at a path is written, through what modules on the way re-export.
    fn home(&self, path: &[String], depth: usize) -> Module {
        let mut module = Module::new();
        for (position, name) in path.iter().enumerate() {
            module.push(name.clone());
            if self.texts.contains_key(&module) {
                continue;
            }
            module.pop();
            let mut uses = self.uses.get(&module).into_iter().flatten();
            let target = uses.find(|(known, _)| known == name).map(|(_, target)| target);
            if let Some(target) = target.filter(|_| depth < 8) {
                return self.home(&[target.as_slice(), &path[position + 1..]].concat(), depth + 1);
            }
            break;
        }
        module
    }

    /// What `use` lines bring into a module.
    fn names(&self, module: &[String], text: &str) -> Vec<(String, Module)> {
        let tokens = tokens(text);
        let statements = tokens.iter().enumerate().filter(|(_, token)| *token == "use");
        statements
            .flat_map(|(position, _)| tree(&tokens[position + 1..]))
            .filter_map(|(path, name)| Some((name, self.absolute(module, &path)?)))
            .collect()
    }
}

/// A file without comments and without its unit tests.
fn text(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("readable file");
    let lines: Vec<&str> = text.lines().collect();
    let tests = lines
        .windows(2)
        .position(|pair| pair[0] == "#[cfg(test)]" && pair[1].starts_with("mod ") && pair[1].ends_with('{'));
    let code = lines[..tests.unwrap_or(lines.len())].iter().map(|line| line.split("//").next().unwrap_or(""));
    code.collect::<Vec<_>>().join("\n")
}

/// Every path of a text that begins at the crate, a parent, the module itself or, behind `use`, a child.
fn paths(text: &str) -> Vec<Vec<String>> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    for (position, token) in tokens.iter().enumerate() {
        let before = position.checked_sub(1).map(|before| tokens[before].as_str());
        let is_start = match token.as_str() {
            "crate" | "super" | "self" => tokens.get(position + 1).is_some_and(|next| next == "::"),
            _ => before == Some("use"),
        };
        if is_start && before != Some("::") {
            found.extend(tree(&tokens[position..]).into_iter().map(|(path, _)| path));
        }
    }
    found
}

/// Names, `::` and single other signs of a text.
fn tokens(text: &str) -> Vec<String> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = match first {
            _ if is_name(first) => rest.find(|c| !is_name(c)).unwrap_or(rest.len()),
            ':' if rest.starts_with("::") => 2,
            _ => first.len_utf8(),
        };
        tokens.push(rest[..length].to_owned());
        rest = rest[length..].trim_start();
    }
    tokens
}

/// The leaves of a path that may branch in braces, with the name that each gets.
fn tree(tokens: &[String]) -> Vec<(Vec<String>, String)> {
    let mut leaves = Vec::new();
    branch(tokens, 0, &[], &mut leaves);
    leaves
}

/// Reads on at `at` behind `prefix`; returns where it ends.
fn branch(
    tokens: &[String],
    mut at: usize,
    prefix: &[String],
    leaves: &mut Vec<(Vec<String>, String)>,
) -> usize {
    let is = |at: usize, sign: &str| tokens.get(at).is_some_and(|token| token == sign);
    let mut path = prefix.to_vec();
    while let Some(token) = tokens.get(at) {
        if token == "{" {
            at += 1;
            while at < tokens.len() && !is(at, "}") {
                at = branch(tokens, at, &path, leaves);
                at += usize::from(is(at, ","));
            }
            return at + 1;
        }
        if !token.chars().all(|c| c.is_alphanumeric() || c == '_') {
            // A star, or what is no path: nothing is named.
            return at + 1;
        }
        if token != "self" || path.is_empty() {
            path.push(token.clone());
        }
        at += 1;
        if is(at, "::") {
            at += 1;
            continue;
        }
        let mut name = path.last().cloned().unwrap_or_default();
        if is(at, "as") {
            name = tokens.get(at + 1).cloned().unwrap_or_default();
            at += 2;
        }
        leaves.push((path, name));
        return at;
    }
    at
}

#[test]
fn paths_branch_in_braces() {
    let found = paths("use crate::a::{self, b::{c, d as e}, f};\nlet x = super::super::g::h(1); use i::j;");
    let found: Vec<String> = found.iter().map(|path| path.join("::")).collect();
    assert_eq!(
        found,
        ["crate::a", "crate::a::b::c", "crate::a::b::d", "crate::a::f", "super::super::g::h", "i::j"]
    );
}
