//! The command line among other programs: closed pipes, files that are there already, little memory.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::PathBuf;
use std::process::{Command, Output};

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What a line of a shell prints that calls the program as `$MOSAIC`, in a folder.
fn shell(folder: &PathBuf, line: &str) -> Output {
    let mut command = Command::new("bash");
    command.args(["-c", line]).current_dir(folder).env("MOSAIC", env!("CARGO_BIN_EXE_mosaic"));
    command.output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

const SMALL: &str = r#"{"initial_cells":60, "days":6, "division_days":{"F":4,"B":6}}"#;

#[test]
fn who_reads_no_further_is_no_error() {
    let folder = folder("pipes");
    fs::write(folder.join("small.json"), SMALL).unwrap();
    for line in [
        "$MOSAIC grow --recipe small.json",
        "$MOSAIC grow --help",
        // Where nobody reads a line, the table is written all the same.
        "$MOSAIC grow --recipe small.json --cells cells.csv",
        "$MOSAIC grow --recipe small.json 2>&1",
    ] {
        // `head` has gone long before the program begins to print.
        let output =
            shell(&folder, &format!("{{ sleep 0.3; {line}; echo $? >status; }} | head -c 0"));
        assert_eq!(text(&output.stderr), "", "{line}");
        assert_eq!(fs::read_to_string(folder.join("status")).unwrap(), "0\n", "{line}");
    }
    assert!(fs::read_to_string(folder.join("cells.csv")).unwrap().lines().count() > 60);
    // Nor is a standard error that is closed.
    let output = shell(&folder, "$MOSAIC shrink 2>&-; echo $?");
    assert_eq!(text(&output.stdout), "2\n");
}

#[test]
fn a_run_that_fails_leaves_the_old_table_whole() {
    let folder = folder("tables");
    fs::write(folder.join("small.json"), SMALL).unwrap();
    fs::write(folder.join("real.csv"), "old").unwrap();
    symlink("real.csv", folder.join("cells.csv")).unwrap();
    fs::set_permissions(folder.join("real.csv"), fs::Permissions::from_mode(0o640)).unwrap();
    let old = || fs::read_to_string(folder.join("cells.csv")).unwrap();
    let names = || fs::read_dir(&folder).unwrap().count();
    let there = names();

    // Memory for the plant runs out long after the file was named.
    fs::write(folder.join("large.json"), r#"{"initial_cells":2000000}"#).unwrap();
    let line = "ulimit -v 200000; $MOSAIC grow --recipe large.json --cells cells.csv";
    let output = shell(&folder, line);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert_eq!((old().as_str(), names()), ("old", there + 1));

    // And the disk, as far as a limit on files goes: the table is longer than one block.
    fs::remove_file(folder.join("large.json")).unwrap();
    let line = "trap '' XFSZ; ulimit -f 1; exec $MOSAIC grow --recipe small.json --cells cells.csv";
    let output = shell(&folder, line);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert!(text(&output.stderr).starts_with("mosaic: cannot write "));
    assert_eq!((old().as_str(), names()), ("old", there), "nothing is left lying about");

    let output = shell(&folder, "$MOSAIC grow --recipe small.json --cells cells.csv");
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(old().starts_with("id,parent,") && names() == there);
    let real = fs::symlink_metadata(folder.join("real.csv")).unwrap();
    assert!(real.is_file() && real.permissions().mode() & 0o777 == 0o640);
    assert!(fs::symlink_metadata(folder.join("cells.csv")).unwrap().is_symlink());

    // A pipe is written as it is.
    let line = "$MOSAIC grow --recipe small.json --json --cells >(wc -l >lines) >run && sleep 0.5; cat lines";
    assert!(text(&shell(&folder, line).stdout).trim().parse::<usize>().unwrap() > 60);
    // And so is what is no file, which would be replaced by one.
    assert!(shell(&folder, "$MOSAIC grow --recipe small.json --cells /dev/null").status.success());
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn too_little_memory_is_told_on_one_line() {
    let folder = folder("memory");
    fs::write(folder.join("large.json"), r#"{"initial_cells":2000000}"#).unwrap();
    let output = shell(&folder, "ulimit -v 200000; $MOSAIC grow --recipe large.json");
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert_eq!(text(&output.stderr), "mosaic: there is not enough memory for this\n");
}

#[test]
fn a_package_for_learning_platforms_names_all_its_files() {
    let folder = folder("scorm");
    fs::create_dir(folder.join("meshes")).unwrap();
    let mut files = ["a & b.js", "index.html", "meshes/leaf.txt"];
    for name in files {
        fs::write(folder.join(name), name).unwrap();
    }
    let playground = concat!(env!("CARGO_MANIFEST_DIR"), "/playground");
    let line =
        format!("'{playground}' scorm-manifest \"$PWD\" >imsmanifest.xml && cat imsmanifest.xml");
    let output = shell(&folder, &line);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let manifest = text(&output.stdout);
    let document = roxmltree::Document::parse(&manifest).unwrap();
    let tags = |name: &'static str| {
        document.descendants().filter(move |node| {
            node.has_tag_name(("http://www.imsproject.org/xsd/imscp_rootv1p1p2", name))
        })
    };
    let mut named: Vec<&str> = tags("file").filter_map(|file| file.attribute("href")).collect();
    named.sort_unstable();
    files.sort_unstable();
    assert_eq!(named, files);
    let page = tags("resource").next().unwrap();
    assert_eq!(page.attribute("href"), Some("index.html"));
    let item = tags("item").next().unwrap();
    assert_eq!(item.attribute("identifierref"), page.attribute("identifier"));
}
