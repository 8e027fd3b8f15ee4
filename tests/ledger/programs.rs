//! Programs through the commands: read, shown, and followed over their stock.

use std::fs;

use rayon::prelude::*;
use serde_json::Value;

use crate::command::Place;
use crate::golden::Item;
use crate::motions::{CONTROLS, GROUPS, Group, endless};
use crate::package::Parts;
use crate::plain::{Sums, page};

/// A thread of a micrometre's lead, which takes a minute to follow.
const LONG: &str = "fuzz/corpus/simulate/thread-of-a-micrometre-lead.nc";

/// What a group's programs are read with, as words of a command.
fn words<'a>(group: &Group, var: Option<&'a str>, control: &'a str) -> Vec<&'a str> {
    let mut words = vec!["--dialect", control];
    words.extend(group.tools.iter().flat_map(|tools| ["--tools", tools]));
    words.extend(var.iter().flat_map(|var| ["--var", var]));
    words.extend(group.inch.then_some("--inch"));
    words.extend(group.calculator.then_some(["--decimal-point", "calculator"]).into_iter().flatten());
    words.extend(group.forgets.then_some("--no-g92-persistence"));
    words
}

/// The documents of programs that are read by one run of the command.
fn verified(place: &Place, group: &Group, programs: &[&str], control: &str) -> Vec<Item> {
    let mut sums = Sums::default();
    for name in programs.iter().copied().chain(group.tools) {
        sums.take(name, &place.read(name));
    }
    let var = group.var(programs[0]);
    sums.take("the parameter file", &var.iter().flat_map(|var| place.read(var)).collect::<Vec<u8>>());
    let with = words(group, var.as_deref(), control);
    let document: Value = serde_json::from_slice(&place.json(&[&["verify"], programs, &with].concat())).unwrap();
    let mut documents = document["programs"].as_array().unwrap().clone();
    assert_eq!(documents.len(), programs.len());
    let item = |(program, document): (&&str, &mut Value)| {
        Item::new(format!("verify/{program}/{control}"), &sums.value(document))
    };
    programs.iter().zip(&mut documents).map(item).collect()
}

/// Document of each program under each control; and, of each folder, what is printed of its programs without `--json`,
/// in Spanish, and their canonical motions.
pub fn verify() -> Vec<Item> {
    let place = Place::with_programs();
    let pairs: Vec<_> = GROUPS.iter().flat_map(|group| CONTROLS.map(|control| (group, control))).collect();
    let one = |(group, control): &(&Group, &str)| {
        let programs = group.programs();
        let read: Vec<_> = programs.iter().map(String::as_str).filter(|program| !endless(program, control)).collect();
        let common = |program: &&str| group.var(program).as_deref() == group.var;
        let (together, alone): (Vec<&str>, Vec<&str>) = read.into_iter().partition(common);
        let mut items: Vec<_> = alone.iter().flat_map(|program| verified(&place, group, &[program], control)).collect();
        items.extend(verified(&place, group, &together, control));
        let with = words(group, group.var, control);
        for (name, more) in [("printed", ["--lang", "es"].as_slice()), ("canon", &["--canon"])] {
            let said = place.said(&[&["verify"], together.as_slice(), &with, more].concat());
            items.push(Item::new(format!("verify/{}/{name}/{control}", group.folder), &said));
        }
        items
    };
    pairs.par_iter().flat_map_iter(|pair| -> Vec<Item> { one(pair) }).collect()
}

/// The scenes of LinuxCNC's programs, also of those that are refused; and the page that shows a scene.
pub fn view() -> Vec<Item> {
    let place = Place::with_programs();
    let all = || GROUPS[..3].iter().flat_map(|group| group.programs().into_iter().map(move |program| (group, program)));
    let programs: Vec<_> = all().filter(|(_, program)| !endless(program, "linuxcnc")).enumerate().collect();
    let scene = |(number, (group, program)): &(usize, (&Group, String))| {
        let (var, page_name) = (group.var(program), format!("{number}.html"));
        let with = words(group, var.as_deref(), "linuxcnc");
        place.run(&[&["view", program, "-o", &page_name], with.as_slice()].concat());
        let html = if place.path(&page_name).is_file() { page(&place.read(&page_name)).0 } else { Vec::new() };
        Item::new(format!("view/{program}"), &html)
    };
    let mut items: Vec<_> = programs.par_iter().map(scene).collect();
    for language in ["en", "es"] {
        place.run(&["view", "golden/annex-09-blade-as-printed.nc", "-o", "page.html", "--lang", language]);
        items.push(Item::new(format!("view/page/{language}"), &page(&place.read("page.html")).1));
    }
    items
}

/// The document and the files of turning programs that are followed over their stock.
pub fn simulate() -> Vec<Item> {
    let place = Place::with_programs();
    let groups = GROUPS.iter().filter(|group| group.folder.starts_with("lathe/") || group.folder.ends_with("simulate"));
    let programs = groups.flat_map(Group::programs).filter(|program| program != LONG);
    let programs: Vec<_> = programs.enumerate().collect();
    let one = |(number, program): &(usize, String)| {
        let bytes = place.read(program);
        let text = String::from_utf8_lossy(&bytes);
        let stock = text.lines().take(3).find_map(|line| line.trim_start_matches(['(', ';']).strip_prefix("stock "));
        let stock = stock.map(|stock| ["--stock", stock.trim_end_matches(')').trim()]);
        let control = if program.contains("fagor") { "fagor-8055-t" } else { "fanuc-lathe-a" };
        let folder = format!("out-{number}");
        let words = ["simulate", program, "--dialect", control, "--decimal-point", "calculator", "-o", &folder];
        let document = place.json(&[words.as_slice(), stock.as_ref().map_or(&[], |stock| stock)].concat());
        let mut sums = Sums::default();
        sums.take(program, &bytes);
        let files = place.files(&folder);
        files.iter().for_each(|file| sums.take(file, &place.read(&format!("{folder}/{file}"))));
        let document = String::from_utf8(sums.json(&document)).unwrap().replace(&folder, "out");
        let mut items = vec![Item::new(format!("simulate/{program}"), document.as_bytes())];
        for file in files {
            let bytes = place.read(&format!("{folder}/{file}"));
            let (_, ending) = file.rsplit_once('.').unwrap();
            let bytes = match ending {
                "xlsx" => Parts::of(&bytes).plain().into_values().flatten().collect(),
                "html" => page(&bytes).0,
                _ => bytes,
            };
            items.push(Item::new(format!("simulate/{program}/{ending}"), &sums.named(&bytes)));
        }
        fs::remove_dir_all(place.path(&folder)).unwrap();
        items
    };
    programs.par_iter().flat_map_iter(|program| -> Vec<Item> { one(program) }).collect()
}

/// Work offsets shown, edited, and exchanged with a workbook.
pub fn offsets() -> Vec<Item> {
    let place = Place::with_programs();
    let (mut items, mut sums) = (Vec::new(), Sums::default());
    let mut put = |name: &str, bytes: &[u8]| items.push(Item::new(format!("offsets/{name}"), bytes));
    for name in ["g92-from-file", "home-from-file", "rotation-from-file", "source-square"] {
        let (file, held) = (format!("{name}.var"), place.read(&format!("gcode/good/{name}.var")));
        place.write(&file, &held);
        sums.take(&file, &held);
        put(&format!("{name}/shown"), &sums.json(&place.json(&["offsets", &file, "--inch"])));
        put(&format!("{name}/printed"), &place.said(&["offsets", &file, "--lang", "es"]));
        for language in ["en", "es"] {
            let book = format!("{name}-{language}.xlsx");
            place.run(&["offsets", &file, "--workbook", &book, "--lang", language]);
            for (part, content) in Parts::of(&place.read(&book)).plain() {
                put(&format!("{name}/{language}/{part}"), &content);
            }
        }
        let set = ["offsets", &file, "--set", "G55 X1.5 Y-2 R30", "--set", "G92 X1", "--use", "G55"];
        put(&format!("{name}/refused"), &place.said(&set));
        let set = ["offsets", &file, "--set", "G55 X1.5 Y-2 R30", "--set", "G52 Z4", "--use", "G55"];
        put(&format!("{name}/set"), &sums.json(&place.json(&set)));
        put(&format!("{name}/file"), &place.read(&file));
    }
    items
}

/// What the commands say of themselves.
pub fn help() -> Vec<Item> {
    let place = Place::new();
    let commands = ["new", "check", "build", "verify", "view", "simulate", "offsets"];
    let mut items: Vec<_> = commands
        .iter()
        .map(|command| Item::new(format!("help/{command}"), &place.said(&[command, "--help"])))
        .collect();
    for word in ["--help", "-h", "nonsense"] {
        items.push(Item::new(format!("help/rodete/{}", word.trim_matches('-')), &place.said(&[word])));
    }
    items
}
