//! The command: the same rows however a plan is divided, resumed and repeated, and how it ends.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use calamine::{Reader, Xlsx, open_workbook};
use rodete::kinds::impeller::cases::CASES;
use rodete::text::Language;

use crate::common::workbook::{Parts, quick, thick, with_variants, with_variants_of};

/// 36 designs, some of them refused: judged by the derived limits, or by the programs.
fn book(level: &str) -> Vec<u8> {
    let settings = [("method", "factorial"), ("level", level), ("objectives", "gap_true max; e_max min")];
    let inputs = [["R", "22", "30", "4", "", ""], ["N", "", "", "", "4; 5; 6", ""], ["e", "1", "4", "1", "", ""]];
    with_variants_of(&thick(quick()), &settings, &inputs, &[])
}

/// A folder with the workbook.
fn folder(level: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.xlsx"), book(level)).unwrap();
    folder
}

fn sweep(folder: &Path, words: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rodete"))
        .current_dir(folder)
        .env("LC_ALL", "C")
        .args(["sweep", "a.xlsx"])
        .args(if words.contains("--top") { &[][..] } else { &["--top", "0"][..] })
        .args(words.split_whitespace())
        .output()
        .unwrap()
}

#[track_caller]
fn done(folder: &Path, words: &str) -> String {
    let output = sweep(folder, words);
    assert_eq!(output.status.code(), Some(0), "{words}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn summary(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name).join("summary.parquet")).unwrap()
}

fn chunks(folder: &Path, name: &str) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(folder.join(name).join("chunks")).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "parquet"));
    paths.sort();
    paths
}

/// What is said of designs that are all rejected is said of those that were tried.
#[test]
fn a_plan_that_is_limited_is_not_rejected_whole() {
    let folder = tempfile::tempdir().unwrap();
    let settings = [("method", "factorial"), ("level", "limits"), ("objectives", "gap_true max")];
    fs::write(folder.path().join("a.xlsx"), with_variants(&settings, &[["e", "50", "60", "5", "", ""]], &[])).unwrap();
    for (limit, said) in [
        ("--limit 1", "rejects the only design tried, of the 3 of the plan;"),
        ("--limit 2", "rejects all 2 designs tried, of the 3 of the plan;"),
        ("", "rejects all 3 designs of the plan;"),
    ] {
        let output = sweep(folder.path(), &format!("-o s{} {limit}", said.len()));
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(3) && told.contains(said), "{limit}: {told}");
    }
}

#[test]
fn the_summary_is_the_same_however_the_plan_is_divided_and_worked() {
    let folder = folder("limits");
    let at = folder.path();
    let told = done(at, "-o one --chunks 1 --jobs 1");
    assert!(told.starts_with("36 designs: "), "{told}");
    let one = summary(at, "one");
    assert!(one.len() > 1000);
    done(at, "-o many --chunks 12 --jobs 3");
    assert!(summary(at, "many") == one, "12 chunks");
    // Each by itself, in another order, and one of them twice.
    for number in [7, 3, 11, 0, 5, 9, 1, 10, 2, 8, 6, 4, 7] {
        done(at, &format!("-o shuffled --chunk {number}/12"));
    }
    done(at, "-o shuffled --merge");
    assert!(summary(at, "shuffled") == one, "shuffled");
    // Interrupted: chunks are missing, one is torn.
    done(at, "-o resumed --chunks 12");
    let there = chunks(at, "resumed");
    assert_eq!(there.len(), 12);
    let whole = fs::read(&there[4]).unwrap();
    fs::remove_file(&there[2]).unwrap();
    fs::write(&there[4], &whole[..whole.len() / 2]).unwrap();
    fs::remove_file(at.join("resumed/summary.parquet")).unwrap();
    let again = sweep(at, "-o resumed");
    let told = String::from_utf8(again.stderr).unwrap();
    assert!(again.status.code() == Some(0) && told.contains("caution D0205: "), "{told}");
    assert!(summary(at, "resumed") == one, "resumed");
    assert_eq!(fs::read(&there[4]).unwrap(), whole);
}

#[test]
fn what_is_missing_is_listed_and_has_an_exit_code_of_its_own() {
    let folder = folder("limits");
    let at = folder.path();
    for number in [0, 2, 3, 7, 11] {
        done(at, &format!("-o s --chunk {number}/12"));
    }
    let merge = sweep(at, "-o s --merge");
    let told = String::from_utf8(merge.stderr).unwrap();
    assert_eq!(merge.status.code(), Some(9), "{told}");
    assert!(told.contains("missing chunks: 7 of 12 (1,4-6,8-10)"), "{told}");
    assert!(!at.join("s/summary.parquet").exists());
}

#[test]
fn a_folder_of_another_plan_is_refused_until_it_is_begun_anew() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s");
    let other = sweep(at, "-o s --limit 20");
    assert_eq!(other.status.code(), Some(3));
    assert!(String::from_utf8(other.stderr).unwrap().contains("error D0201: "));
    assert!(done(at, "-o s --limit 20 --fresh").starts_with("20 designs: "));
    assert_eq!(chunks(at, "s").len(), 1, "nothing of the other plan is left");
}

#[test]
fn to_begin_anew_removes_what_a_run_left_and_nothing_else() {
    let folder = folder("limits");
    let at = folder.path();
    // In a folder without a plan there is nothing to remove, and the workbook itself may be in it.
    fs::create_dir_all(at.join("top")).unwrap();
    let mine = ["b-sweep.xlsx", "top/mine.nc", "top/a-part.xlsx", "summary.csv"];
    mine.iter().for_each(|name| fs::write(at.join(name), "mine").unwrap());
    done(at, "-o . --fresh --chunks 1 --top 1");
    let mine = ["b-sweep.xlsx", "top/mine.nc", "top/a-part.xlsx"];
    // The name of a design, and of what is made of it, does not make it one.
    let others = ["top/a-000000-mine.xlsx", "top/a-999999.xlsx", "top/a-000000-fixture.nc", "summary.csv"];
    others.iter().for_each(|name| fs::write(at.join(name), "mine").unwrap());
    fs::write(at.join("chunks/notes.parquet"), "mine").unwrap();
    let before = chunks(at, ".").len();
    let tops = fs::read_dir(at.join("top")).unwrap().count();
    done(at, "-o . --fresh --chunks 3 --top 0");
    assert!(mine.iter().chain(&others).all(|name| fs::read_to_string(at.join(name)).unwrap() == "mine"));
    assert!(at.join("a.xlsx").exists() && at.join("a-sweep.xlsx").exists());
    assert_eq!((tops > 5, fs::read_dir(at.join("top")).unwrap().count()), (true, 5), "two and three of mine are left");
    assert_eq!((before, chunks(at, ".").len()), (2, 4), "one chunk and the other file, then three and the same file");
}

/// A result that somebody edited, or a file that has its name, is neither replaced nor removed, and the rows are kept.
#[test]
fn what_was_changed_since_is_neither_replaced_nor_removed() {
    let folder = folder("limits");
    let at = folder.path();
    let refused = |words: &str, path: &str| {
        let out = sweep(at, words);
        let told = String::from_utf8(out.stderr).unwrap();
        assert_eq!(out.status.code(), Some(5), "{told}");
        assert!(told.contains(&format!("error D0211: {path} is not of a sweep, or was changed after")), "{told}");
    };
    // A workbook of the user's that has the name of the results; before any design is worked out.
    fs::write(at.join("a-sweep.xlsx"), "mine").unwrap();
    refused("-o . --top 1", "./a-sweep.xlsx");
    assert!(!at.join("chunks").exists(), "nothing is worked out");
    fs::remove_file(at.join("a-sweep.xlsx")).unwrap();
    done(at, "-o s --top 1");
    // The same again replaces what it wrote.
    done(at, "-o s --top 1");
    let designs =
        || fs::read_dir(at.join("s/top")).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    for name in designs().collect::<Vec<_>>() {
        let (path, shown) = (at.join("s/top").join(&name), format!("s/top/{name}"));
        let before = fs::read(&path).unwrap();
        fs::write(&path, "edited").unwrap();
        for words in ["-o s --top 1", "-o s --top 1 --fresh"] {
            refused(words, &shown);
            assert_eq!(fs::read_to_string(&path).unwrap(), "edited");
            assert_eq!(chunks(at, "s").len(), 1, "the rows are kept");
        }
        fs::write(&path, before).unwrap();
    }
    assert!(designs().count() >= 2, "the design and its results");
    // A killed run may have written a file that its record does not know as it stands: the same plan gives the same bytes.
    fs::remove_file(at.join("s/top").join(designs().find(|name| name.ends_with("-results.xlsx")).unwrap())).unwrap();
    done(at, "-o s --top 1");
    done(at, "-o s --top 1 --fresh");
}

/// Excel asks to save a workbook that was only looked at: its bytes are others, the rows are the same.
#[test]
fn a_workbook_that_is_saved_again_with_the_same_values_goes_on() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s --chunk 0/2");
    let first = chunks(at, "s");
    let book = book("limits");
    let again = Parts::of(&book).stored();
    assert_ne!(book, again);
    fs::write(at.join("a.xlsx"), again).unwrap();
    done(at, "-o s");
    assert_eq!(chunks(at, "s").len(), 2);
    assert!(chunks(at, "s").starts_with(&first), "under the name that they began with");
    // Another value, of an input that does not vary, is another plan.
    fs::write(at.join("a.xlsx"), Parts::of(&book).number("a_p", "1.9").zip()).unwrap();
    assert!(String::from_utf8(sweep(at, "-o s").stderr).unwrap().contains("error D0201: "));
}

#[test]
fn to_begin_anew_removes_nothing_of_another_workbook() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s --top 1");
    let left = |of: &str| {
        let mut names: Vec<_> = fs::read_dir(at.join(of)).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    let before = ["s", "s/chunks", "s/top"].map(left);
    let other = |words: &str| {
        let rodete = env!("CARGO_BIN_EXE_rodete");
        let words = ["sweep", "b.xlsx", "--top", "0"].into_iter().chain(words.split_whitespace());
        let output = Command::new(rodete).current_dir(at).env("LC_ALL", "C").args(words).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    // A workbook of the same bytes: its rows are there, but the sheets are not its own.
    fs::copy(at.join("a.xlsx"), at.join("b.xlsx")).unwrap();
    for words in ["-o s --fresh", "-o s --limit 20", "-o s --fresh --limit 20"] {
        let (code, told) = other(words);
        assert_eq!(code, Some(3), "{told}");
        assert!(
            told.contains("error D0210: s holds rows of another workbook, a.xlsx\nhint: choose another folder"),
            "{told}"
        );
        assert_eq!(["s", "s/chunks", "s/top"].map(left), before);
    }
    assert_eq!(other("-o s").0, Some(0), "the same rows are gone on with");
    // The own workbook begins anew, changed or not.
    fs::write(at.join("a.xlsx"), book("program")).unwrap();
    assert!(String::from_utf8(sweep(at, "-o s --limit 20").stderr).unwrap().contains("error D0201: "));
    assert!(done(at, "-o s --limit 20 --fresh").starts_with("20 designs: "));
    // A plan that names no workbook, as earlier versions wrote it, may be of this one.
    let plan = at.join("s/plan.json");
    let mut told: serde_json::Value = serde_json::from_slice(&fs::read(&plan).unwrap()).unwrap();
    assert_eq!(told.as_object_mut().unwrap().remove("workbook").unwrap(), "a.xlsx");
    fs::write(&plan, told.to_string()).unwrap();
    assert!(String::from_utf8(sweep(at, "-o s --limit 21").stderr).unwrap().contains("error D0201: "));
    assert!(done(at, "-o s --limit 21 --fresh").starts_with("21 designs: "));
}

#[test]
fn what_a_chunk_took_stands_beside_its_rows_and_goes_with_them() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s --chunks 2 --jobs 1");
    let log = chunks(at, "s")[1].with_extension("log.json");
    let took: serde_json::Value = serde_json::from_slice(&fs::read(&log).unwrap()).unwrap();
    let plan: serde_json::Value = serde_json::from_slice(&fs::read(at.join("s/plan.json")).unwrap()).unwrap();
    assert_eq!(took["jobs"], 1);
    assert_eq!(took["designs"].as_u64().unwrap(), plan["plan"]["count"].as_u64().unwrap().div_ceil(2));
    assert!(took["seconds"].as_f64().unwrap() > 0.0 && took["host"].is_string(), "{took}");
    assert!(!cfg!(target_os = "linux") || took["peak_memory_kib"].as_u64().unwrap() > 1000, "{took}");
    done(at, "-o s --fresh --chunks 1");
    assert!(!log.exists());
}

#[test]
fn a_chunk_of_which_a_column_is_damaged_counts_as_missing() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s --chunks 4");
    let there = chunks(at, "s");
    let whole = fs::read(&there[2]).unwrap();
    // What is not of the first column: half of the bytes before the footer.
    let mut spoilt = whole.clone();
    let (from, to) = (whole.len() / 4, whole.len() / 2);
    spoilt[from..to].iter_mut().step_by(7).for_each(|byte| *byte ^= 0x55);
    fs::write(&there[2], &spoilt).unwrap();
    let merge = sweep(at, "-o s --merge");
    let told = String::from_utf8(merge.stderr).unwrap();
    assert!(merge.status.code() == Some(9) && told.contains("missing chunks: 1 of 4 (2)"), "{told}");
    done(at, "-o s --chunk 2/4");
    assert!(fs::read(&there[2]).unwrap() == whole);
}

#[test]
fn all_damaged_chunks_are_listed_at_once_whichever_of_their_columns_it_is() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s --chunks 6");
    let there = chunks(at, "s");
    for (number, path) in there.iter().enumerate().filter(|(number, _)| number % 2 == 1) {
        let mut bytes = fs::read(path).unwrap();
        // Of one chunk the first column, of the others later ones.
        let (from, to) = if number == 1 { (8, 24) } else { (bytes.len() / 4, bytes.len() / 2) };
        bytes[from..to].iter_mut().step_by(7).for_each(|byte| *byte ^= 0x55);
        fs::write(path, &bytes).unwrap();
    }
    let merge = sweep(at, "-o s --merge");
    let told = String::from_utf8(merge.stderr).unwrap();
    assert!(merge.status.code() == Some(9) && told.contains("missing chunks: 3 of 6 (1,3,5)"), "{told}");
    // Of these the first column can be read.
    done(at, "-o s --chunk 1/6");
    let merge = sweep(at, "-o s --merge");
    let told = String::from_utf8(merge.stderr).unwrap();
    assert!(merge.status.code() == Some(9) && told.contains("missing chunks: 2 of 6 (3,5)"), "{told}");
}

#[test]
fn a_merge_of_an_empty_folder_leaves_it_to_be_divided_in_any_way() {
    let folder = folder("limits");
    let at = folder.path();
    let merge = sweep(at, "-o s --merge");
    assert_eq!(merge.status.code(), Some(9), "{}", String::from_utf8_lossy(&merge.stderr));
    assert!(!at.join("s/plan.json").exists());
    done(at, "-o s --chunk 0/2");
    done(at, "-o s --chunk 1/2");
    done(at, "-o s --merge");
}

#[test]
fn an_array_of_more_tasks_than_designs_ends_well_and_gives_the_same_summary() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o one --limit 14 --chunks 1");
    for task in (0..16).rev() {
        done(at, &format!("-o s --limit 14 --chunk {task}/16"));
    }
    assert_eq!(chunks(at, "s").len(), 16);
    done(at, "-o s --limit 14 --merge");
    assert!(summary(at, "s") == summary(at, "one"));
    done(at, "-o all --limit 14 --chunks 16");
    assert!(summary(at, "all") == summary(at, "one"));
}

#[test]
fn rows_are_written_for_refused_designs_and_name_no_folder() {
    let folder = folder("program");
    let at = folder.path();
    let told = done(at, "-o s --csv --jobs 2");
    assert!(told.contains(" refused, 0 failed"), "{told}");
    let csv = fs::read_to_string(at.join("s/summary.csv")).unwrap();
    let mut lines = csv.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|one| *one == name).unwrap_or_else(|| panic!("no {name}"));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 36);
    let refused: Vec<_> = rows.iter().filter(|row| row[column("state")] == "refused").collect();
    let done: Vec<_> = rows.iter().filter(|row| row[column("state")] == "done").collect();
    assert!(!refused.is_empty() && !done.is_empty());
    for row in &refused {
        assert!(row[column("stop")].parse::<u32>().unwrap() > 0);
        assert!(row[column("codes")].contains(row[column("reason")]), "{row:?}");
        assert_eq!(row[column("time_s")], "", "what is refused has no time");
    }
    assert!(refused.iter().any(|row| row[column("margin")].parse::<f64>().is_ok_and(|margin| margin < 0.0)));
    for row in &done {
        assert!(row[column("time_s")].parse::<f64>().unwrap() > 0.0, "{row:?}");
        assert_eq!((row[column("reason")], row[column("margin")]), ("", ""));
    }
    assert_eq!(rows.iter().map(|row| row[0].parse().unwrap()).collect::<Vec<u32>>(), (0..36).collect::<Vec<_>>());
    assert!(!csv.contains(&at.to_string_lossy().into_owned()) && !csv.contains("a.xlsx"));
    assert!(at.join("s/a-sweep.xlsx").is_file());
}

#[test]
fn designs_that_are_cut_clear_are_compared_by_what_their_judges_measure() {
    let case = CASES.iter().find(|case| case.name == "clear").unwrap();
    let settings = [("method", "factorial"), ("objectives", "under_floor_mm min; clearance_mm max")];
    let inputs = [["R", "", "", "", "25; 26", ""], ["a_p", "", "", "", "1.5; 2", ""], ["e", "", "", "", "2", ""]];
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("a.xlsx"), with_variants_of(&thick(case), &settings, &inputs, &[])).unwrap();
    let told = done(at, "-o s --csv --jobs 2");
    assert!(told.starts_with("4 designs: 4 done, 0 refused, 0 failed; 4 feasible, "), "{told}");
    let csv = fs::read_to_string(at.join("s/summary.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    for row in &rows[1..] {
        let cell = |name: &str| row[rows[0].iter().position(|one| *one == name).unwrap()];
        for measured in ["under_floor_mm", "clearance_mm", "time_s"] {
            assert!(cell(measured).parse::<f64>().is_ok_and(f64::is_finite), "{measured}: {row:?}");
        }
        assert_eq!(cell("deviation_mm"), "", "{row:?}");
    }
}

#[test]
fn the_best_designs_are_workbooks_that_are_built() {
    let folder = folder("program");
    let at = folder.path();
    done(at, "-o s --top 2");
    let names: Vec<String> = fs::read_dir(at.join("s/top"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(names.iter().filter(|name| name.ends_with("-results.xlsx")).count(), 2, "{names:?}");
    assert!(names.iter().any(|name| name.ends_with("-blade.nc")), "{names:?}");
}

#[test]
fn the_top_shows_the_whole_front_and_says_how_many_of_it_are_not_built() {
    let folder = folder("limits");
    let at = folder.path();
    done(at, "-o s --top 2 --csv");
    let csv = fs::read_to_string(at.join("s/summary.csv")).unwrap();
    let front: Vec<&str> =
        csv.lines().filter(|line| line.ends_with("true")).map(|line| line.split(',').next().unwrap()).collect();
    assert!(front.len() > 2, "{front:?}");
    let parts = Parts::of(&fs::read(at.join("s/a-sweep.xlsx")).unwrap());
    let top = parts.text("xl/worksheets/sheet1.xml");
    for id in &front {
        assert!(top.contains(&format!("<v>{id}</v></c><c r=\"C")), "{id}: {top}");
    }
    assert_eq!(top.matches("<hyperlink ").count(), 2);
    let told = format!("Of the front, not built: {}; --top builds more.", front.len() - 2);
    assert!(parts.text("xl/sharedStrings.xml").contains(&told), "{told}");
    // All of it built: nothing is said.
    done(at, "-o s --top 40");
    let parts = Parts::of(&fs::read(at.join("s/a-sweep.xlsx")).unwrap());
    assert!(!parts.text("xl/sharedStrings.xml").contains("not built: "));
}

#[test]
fn charts_part_designs_that_break_a_constraint_from_the_feasible_the_front_and_others_of_the_top() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let settings = [
        ("method", "factorial"),
        ("level", "limits"),
        ("objectives", "gap_true max; e_max min"),
        ("constraints", "N_max >= 5"),
    ];
    let inputs = [["R", "22", "30", "4", "", ""], ["N", "", "", "", "3; 4; 5", ""], ["e", "1", "4", "0.5", "", ""]];
    fs::write(at.join("a.xlsx"), with_variants_of(&thick(quick()), &settings, &inputs, &[])).unwrap();
    done(at, "-o s --csv");
    let csv = fs::read_to_string(at.join("s/summary.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let cell = |row: &[&str], name: &str| row[rows[0].iter().position(|one| *one == name).unwrap()].to_owned();
    let done: Vec<_> = rows[1..].iter().filter(|row| cell(row, "state") == "done").collect();
    let broken = done.iter().filter(|row| cell(row, "feasible") == "false").count();
    let front = done.iter().filter(|row| cell(row, "front") == "true").count();
    let feasible = done.len() - broken - front;
    assert!(broken > 0 && front > 0 && feasible > 0, "{broken} {feasible} {front}");
    let parts = Parts::of(&fs::read(at.join("s/a-sweep.xlsx")).unwrap());
    let chart = (1..)
        .map(|number| format!("xl/charts/chart{number}.xml"))
        .take_while(|part| parts.has(part))
        .map(|part| parts.text(&part))
        .find(|chart| chart.contains("gap_true [mm] / e_max") || chart.contains("e_max [mm] / gap_true"))
        .unwrap();
    let mut first = 2;
    // The front is the first in the file, and the last in order: one program draws the first on top, another the last.
    for ((name, count), order) in
        [("Front", front), ("Feasible", feasible), ("Constraint broken", broken)].into_iter().zip([2, 1, 0])
    {
        let series = chart.split("<c:ser>").nth(3 - order).unwrap();
        assert!(
            series.contains(&format!(">{name}<")) && series.contains(&format!("<c:order val=\"{order}\"/>")),
            "{series}"
        );
        let last = first + count - 1;
        assert!(series.contains(&format!("POINTS!$E${first}:$E${last}<")), "{name} {first} {last}: {series}");
        first = last + 1;
    }
    assert!(!chart.contains("Others of the top"), "with --top 0 there are none");
}

/// The first design with a broken constraint is told with its value and by how much it misses, as other refusals are.
#[test]
fn why_says_by_how_much_a_constraint_is_broken_and_of_what_a_design_has_no_value() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    for (lang, sheet, said) in [("en", "WHY", ["is", "it breaks", "by"]), ("es", "POR_QUE", ["es", "incumple", "por"])]
    {
        let settings = [
            ("method", "factorial"),
            ("level", "limits"),
            ("objectives", "gap_true max"),
            ("constraints", "N_max >= 5; e_max <= 0.5"),
        ];
        let inputs = [["R", "22", "30", "4", "", ""], ["e", "1", "4", "0.5", "", ""]];
        fs::write(at.join("a.xlsx"), with_variants_of(&thick(quick()), &settings, &inputs, &[])).unwrap();
        done(at, &format!("-o s --csv --fresh --lang {lang}"));
        let csv = fs::read_to_string(at.join("s/summary.csv")).unwrap();
        let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
        let cell = |row: &[&str], name: &str| row[rows[0].iter().position(|one| *one == name).unwrap()].to_owned();
        let mut book: Xlsx<_> = open_workbook(at.join("s/a-sweep.xlsx")).unwrap();
        let why = book.worksheet_range(sheet).unwrap();
        let mut seen = 0;
        for (reason, key) in [("N_max >= 5", "N_max"), ("e_max <= 0.5", "e_max")] {
            let Some(first) = rows[1..].iter().find(|row| cell(row, "reason") == reason) else { continue };
            let number = |name: &str| cell(first, name).parse::<f64>().unwrap();
            let row = why.rows().find(|row| row[0] == reason).unwrap();
            let told = row[3].to_string();
            let begin = format!("{} {}: {key} {} ", if lang == "es" { "diseño" } else { "design" }, first[0], said[0]);
            let (value, rest) = told.strip_prefix(&begin).unwrap_or_else(|| panic!("{told}")).split_once("; ").unwrap();
            let by =
                rest.strip_prefix(&format!("{} {reason} {} ", said[1], said[2])).unwrap_or_else(|| panic!("{told}"));
            for (shown, exact) in [(value, number("value")), (by, -number("margin"))] {
                let shown: f64 = shown.split(' ').next().unwrap().parse().unwrap();
                assert!(exact > 0.0 && (shown - exact).abs() < 5.1e-5, "{told}: {exact}");
            }
            seen += 1;
        }
        assert!(seen > 0, "{csv}");
    }
}

/// On paper the figures keep their size: columns go on beside, with number and inputs again, and of many rows both ends are printed.
#[test]
fn all_designs_are_printed_at_a_size_that_can_be_read() {
    let folder = folder("limits");
    let at = folder.path();
    let printed = |out: &str| {
        done(at, out);
        let parts = Parts::of(&fs::read(at.join("s/a-sweep.xlsx")).unwrap());
        let (sheet, book) = (parts.text("xl/worksheets/sheet2.xml"), parts.text("xl/workbook.xml"));
        let (scale, set_up) = sheet.split_once("scale=\"").unwrap().1.split_once('"').unwrap();
        assert!((62..=72).contains(&scale.parse::<u16>().unwrap()), "{scale}");
        assert!(set_up.starts_with(" pageOrder=\"overThenDown\" orientation=\"landscape\""));
        assert!(!sheet.contains("fitToPage"));
        (sheet, book)
    };
    let (sheet, book) = printed("-o s");
    assert!(book.contains("localSheetId=\"1\">ALL!$A:$D,ALL!$4:$5<"), "{book}");
    assert!(!book.contains("Print_Area\" localSheetId=\"1\"") && !sheet.contains("rows the first"));
    fs::remove_dir_all(at.join("s")).unwrap();
    let settings = [("method", "factorial"), ("level", "limits"), ("objectives", "e_max min")];
    let inputs = [["R", "22", "32", "0.02", "", ""], ["e", "", "", "", "1; 2", ""]];
    fs::write(at.join("a.xlsx"), with_variants_of(&thick(quick()), &settings, &inputs, &[])).unwrap();
    let (sheet, book) = printed("-o s");
    assert!(sheet.contains("Of 1002 rows the first and the last 45 are printed"));
    let areas = book.split_once("Print_Area\" localSheetId=\"1\">").unwrap().1.split_once('<').unwrap().0;
    let rows: Vec<&str> = areas.split(['$', ',', ':']).filter(|part| part.parse::<u32>().is_ok()).collect();
    assert_eq!(rows, ["1", "50", "963", "1007"], "{areas}");
}

/// Eight groups are too few for an index: no column is headed that stays empty, and the sheet says why.
#[test]
fn indices_are_told_where_there_are_enough_groups_and_else_that_there_are_none() {
    let folder = folder("limits");
    let at = folder.path();
    for (samples, told) in [("8", false), ("32", true)] {
        let settings =
            [("method", "saltelli"), ("samples", samples), ("level", "limits"), ("objectives", "length min")];
        let inputs = [["R", "25", "30", "", "", ""], ["r", "14", "16", "", "", ""]];
        fs::write(at.join("a.xlsx"), with_variants_of(&quick().values(Language::En), &settings, &inputs, &[])).unwrap();
        done(at, "-o s --fresh");
        let parts = Parts::of(&fs::read(at.join("s/a-sweep.xlsx")).unwrap());
        let text = parts.text("xl/sharedStrings.xml");
        assert_eq!(text.contains(">alone<"), told, "{samples}");
        let none = "Sobol's indices: none. They take 16 groups whose designs are feasible, and there are 8 of 8";
        assert_eq!(text.contains(none) || text.contains(&none.replace('\'', "&apos;")), !told, "{samples}: {text}");
    }
}

#[test]
fn a_plan_whose_every_design_is_refused_ends_with_3_and_keeps_its_rows() {
    let folder = tempfile::tempdir().unwrap();
    let settings = [("method", "factorial"), ("level", "limits")];
    fs::write(folder.path().join("a.xlsx"), with_variants(&settings, &[["e", "50", "60", "5", "", ""]], &[])).unwrap();
    let output = sweep(folder.path(), "-o s");
    assert_eq!(output.status.code(), Some(3));
    // The remedy says where to read why.
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("read the sheet WHY of s/a-sweep.xlsx and change the ranges"), "{told}");
    assert!(folder.path().join("s/summary.parquet").is_file() && folder.path().join("s/a-sweep.xlsx").is_file());
}

#[test]
fn a_forecast_writes_nothing() {
    let folder = folder("limits");
    let told = done(folder.path(), "--dry-run");
    assert!(told.starts_with("36 designs, 3 inputs:\n  R (3)\n  N (3)\n  e (4)\n"), "{told}");
    // Eight that are not refused, and those refused on the way.
    let (tried, rest) = told.split_once(" tried, ").unwrap();
    let tried: u32 = tried.rsplit('\n').next().unwrap().trim().parse().unwrap();
    let refused: u32 = rest.split_once(" refused: ").unwrap().0.parse().unwrap();
    assert!(refused > 0 && tried == refused + 8, "{told}");
    assert!(rest.contains(" on one core, ") && !rest.contains("were tried"), "{told}");
    // All that there are, where none is good.
    let settings = [("method", "factorial"), ("level", "limits")];
    fs::write(folder.path().join("a.xlsx"), with_variants(&settings, &[["e", "50", "60", "5", "", ""]], &[])).unwrap();
    let told = done(folder.path(), "--dry-run");
    assert!(told.contains("3 tried, 3 refused: ") && told.contains("rodete refused all that were tried"), "{told}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}
