//! Writing files: whole or not at all, and nothing replaced that is no regular file.
#![allow(clippy::unwrap_used)]

use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::Path;

use ffrf_model::write_file;

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn what_a_killed_run_left_behind_is_removed_and_what_is_in_use_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at(".out.json.4194305-0.ffrf-tmp"), "half").unwrap();
    // Of this process, which is alive: a number used again.
    fs::write(at(&format!(".out.json.{}-0.ffrf-tmp", std::process::id())), "half").unwrap();
    fs::write(at(".other.json.4194305-0.ffrf-tmp"), "of another output").unwrap();
    let in_use = File::create(at(".out.json.1-0.ffrf-tmp")).unwrap();
    in_use.lock().unwrap();
    write_file(at("out.json"), b"whole").unwrap();
    assert_eq!(
        names(folder.path()),
        [".other.json.4194305-0.ffrf-tmp", ".out.json.1-0.ffrf-tmp", "out.json"]
    );
    assert_eq!(fs::read(at("out.json")).unwrap(), b"whole");
    drop(in_use);
    write_file(at("out.json"), b"again").unwrap();
    assert_eq!(names(folder.path()), [".other.json.4194305-0.ffrf-tmp", "out.json"]);
}

#[test]
fn many_writers_of_one_file_leave_one_whole_text() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out");
    let text = |writer: u8| vec![b'a' + writer; 100_000];
    std::thread::scope(|scope| {
        for writer in 0..8 {
            let path = &path;
            scope.spawn(move || (0..20).for_each(|_| write_file(path, &text(writer)).unwrap()));
        }
    });
    let found = fs::read(&path).unwrap();
    assert_eq!(found, text(found[0] - b'a'));
    assert_eq!(names(folder.path()), ["out"]);
}

#[test]
fn a_read_only_file_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("precious");
    fs::write(&path, "old").unwrap();
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let error = write_file(&path, b"new").unwrap_err();
    assert_eq!(error.kind(), ErrorKind::PermissionDenied);
    assert!(error.to_string().contains("read-only"), "{error}");
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["precious"]);
}

#[test]
fn folders_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let error = write_file(folder.path(), b"new").unwrap_err();
    assert!(error.to_string().contains("is a folder"), "{error}");
    write_file(folder.path().join("none/out"), b"new").unwrap_err();
    assert_eq!(names(folder.path()), [""; 0]);
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};

    use super::*;

    #[test]
    fn permissions_of_an_existing_file_stay() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("secret");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
        write_file(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o600);
    }

    #[test]
    fn links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("inner")).unwrap();
        symlink("inner/target", at("link")).unwrap();
        for text in ["made through a link", "replaced through a link"] {
            write_file(at("link"), text.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(at("inner/target")).unwrap(), text);
            assert!(fs::symlink_metadata(at("link")).unwrap().is_symlink());
        }
        symlink("circle", at("circle")).unwrap();
        write_file(at("circle"), b"").unwrap_err();
        assert_eq!(names(&at("inner")), ["target"]);
    }

    #[test]
    fn a_device_is_written_to_and_its_error_told() {
        let full = Path::new("/dev/full");
        if !full.exists() {
            eprintln!("SKIPPED: there is no /dev/full here");
            return;
        }
        let error = write_file(full, b"text").unwrap_err();
        assert_eq!(error.kind(), ErrorKind::StorageFull, "{error}");
        assert!(fs::metadata(full).unwrap().file_type().is_char_device());
        write_file("/dev/null", b"text").unwrap();
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }
}
