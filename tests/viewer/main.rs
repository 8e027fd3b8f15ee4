//! The viewer in Chromium: it draws, plays, goes to blocks, speaks both languages, and asks nobody for anything.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

mod browser;
mod turned;

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use rodete::kinds::KINDS;
use serde_json::{Value, json};
use tempfile::TempDir;

use self::browser::{Browser, chromium};

/// The stage in a picture: x, y, width, height as shares.
const STAGE: [f64; 4] = [0.0, 0.15, 0.6, 0.7];

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// Where pictures are left for whoever wants to look.
fn picture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("viewer-{name}.png"))
}

fn rodete(folder: &Path, arguments: &[&str]) {
    let mut command = Command::cargo_bin("rodete").expect("the binary");
    command.current_dir(folder).args(arguments).assert().success();
}

/// The page of a new workbook of a kind.
fn page_of(folder: &Path, kind: &str) -> PathBuf {
    rodete(folder, &["new", kind]);
    rodete(folder, &["view", &format!("{kind}.xlsx")]);
    folder.join(format!("{kind}.html"))
}

fn turned(folder: &Path, repeat: usize) -> PathBuf {
    let file = folder.join("turned.html");
    fs::write(&file, rodete::view::html(&turned::scene(repeat))).expect("a page");
    file
}

fn real(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Fails on anything on the console and on any request.
fn quiet(browser: &Browser) {
    assert_eq!(browser.console(), Vec::<String>::new());
    let asked = browser.run("return performance.getEntriesByType('resource').map((one) => one.name)");
    assert_eq!(asked, json!([]), "the page asks for nothing");
}

/// Where the bodies of a page reach along X, Y and Z, mm, by their names.
fn reaches(browser: &Browser, name: &str) -> Vec<f64> {
    let script = format!(
        "const points = bodies.find((body) => body.name.en === '{name}').vertices, reach = [];
         for (let axis = 0; axis < 3; axis++) {{
           const along = points.filter((_, at) => at % 6 === axis);
           reach.push(along.reduce((a, b) => Math.min(a, b)), along.reduce((a, b) => Math.max(a, b)));
         }}
         return reach;"
    );
    browser.run(&script).as_array().into_iter().flatten().map(|one| (real(one) * 1000.0).round() / 1000.0).collect()
}

/// Fails on a picture of one colour.
fn drawn(browser: &Browser, name: &str) {
    let counts = browser.picture(&picture(name), STAGE);
    let (all, most) = (counts.iter().map(|(_, count)| count).sum::<u64>(), counts[0].1);
    assert!(counts.len() > 12 && all - most > all / 40, "{name}: {:?}", &counts[..counts.len().min(5)]);
}

#[test]
fn a_page_names_no_other_place() {
    let folder = folder();
    for kind in KINDS.iter().map(|kind| kind.form().kind) {
        let text = fs::read_to_string(page_of(folder.path(), kind)).expect("a page");
        for outside in ["://", "fetch(", "XMLHttp", "import(", "@import", "src=\"", "url("] {
            assert!(!text.contains(outside), "{kind}: {outside}");
        }
        assert!(text.contains("default-src 'none'"));
    }
}

#[test]
fn parts_and_programs_are_drawn_and_played() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(true);
    for kind in ["impeller", "pipe-insert", "pipe-hole"] {
        let page = page_of(folder.path(), kind);
        let status = browser.open(&page, "");
        assert_eq!(status["renderer"], "webgl2", "{kind}");
        assert!(real(&status["triangles"]) > 1000.0, "{kind}: {status}");
        let end = browser.open(&page, &format!("step={}", real(&status["motions"]) / 2.0));
        drawn(&browser, kind);
        assert_eq!(real(&end["cursor"]), real(&status["motions"]) / 2.0);
        let began = browser.open(&page, "play");
        let later = browser.until("time moves on", |now| real(&now["time"]) > real(&began["time"]) + 0.2);
        assert!(real(&later["cursor"]) > 0.0, "{later}");
        quiet(&browser);
    }
}

#[test]
fn cameras_and_fit_take_in_the_torch_where_it_stands() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(true);
    let seen = |what: &str| {
        let reach = browser.run(
            "const { matrix } = camera.matrix(camera.aspect);
             const along = (row, [x, y, z]) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row];
             return standingTorch().flatMap((one) => [0, 1].map((row) => Math.abs(along(row, one) / along(3, one))));",
        );
        let reach: Vec<f64> = reach.as_array().expect("points").iter().map(real).collect();
        assert!(
            !reach.is_empty() && reach.iter().all(|&at| at < 1.0),
            "{what}: {:?}",
            reach.iter().copied().reduce(f64::max)
        );
    };
    for kind in ["pipe-insert", "pipe-hole"] {
        let page = page_of(folder.path(), kind);
        for place in ["", "time=3"] {
            browser.open(&page, place);
            seen(&format!("{kind} {place}"));
            for key in ["1", "2", "3", "4", "5", "6"] {
                browser.keys(&[key]);
                seen(&format!("{kind} {place} camera {key}"));
            }
        }
        // Where it has gone since, the key fetches it.
        browser.run("goTo(Math.floor(run.count / 2))");
        browser.keys(&["f"]);
        seen(&format!("{kind} F"));
    }
    // The shank of a milling tool does not make the part small.
    browser.open(&page_of(folder.path(), "impeller"), "view=front");
    assert_eq!(browser.run("return standingTorch()"), json!([]));
    quiet(&browser);
}

#[test]
fn a_clear_cut_is_played_pass_by_pass_with_both_of_its_tools() {
    if !chromium() {
        return;
    }
    let folder = folder();
    rodete(folder.path(), &["new", "impeller", "clear.xlsx", "--case", "clear"]);
    rodete(folder.path(), &["view", "clear.xlsx"]);
    let page = folder.path().join("clear.html");
    let browser = Browser::start(true);
    for (program, tool, radius) in [(1, 1.0, 3.0), (2, 2.0, 1.5)] {
        let status = browser.open(&page, &format!("program={program}"));
        let mut cursors = vec![real(&status["cursor"])];
        for _ in 0..3 {
            cursors.push(real(&browser.keys(&["\u{E00F}"])["cursor"]));
        }
        assert!(cursors.windows(2).all(|pair| pair[0] < pair[1]), "{cursors:?}");
        assert_eq!(
            browser.run("return [run.kind[cursor], run.modal[cursor - 1]]"),
            json!([1, 0]),
            "a feed move, a rapid one"
        );
        let said = browser.run(
            "const motion = run.at(cursor + 0.5)[0], number = run.states[run.state[motion]].tool;
             const across = toolOf(number).flatMap(({ vertices }) => Array.from(vertices).filter((_, at) => at % 6 === 0));
             return [number, Math.max(...across)];",
        );
        assert_eq!([real(&said[0]), real(&said[1])], [tool, radius], "the tool in its size");
        drawn(&browser, &format!("clear-{program}"));
        let back = browser.keys(&["\u{E00E}"]);
        assert_eq!(real(&back["cursor"]), cursors[2]);
    }
    quiet(&browser);
}

#[test]
fn the_torch_runs_along_the_edge_of_the_pipe_that_it_cuts() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let page = page_of(folder.path(), "pipe-insert");
    let browser = Browser::start(true);
    let status = browser.open(&page, "view=section");
    let reach = reaches(&browser, "Part");
    // From the edge X0 along X, 88.9 mm across.
    assert_eq!((reach[0], &reach[2..]), (0.0, &[-44.45, 44.45, -44.45, 44.45][..]), "{reach:?}");
    drawn(&browser, "pipe-insert-section");
    // Every point of the cut is half a kerf from the nearest point of the part's edge.
    let off = browser.run(
        "const edge = bodies.find((body) => body.name.en === 'Part').vertices, far = [];
         for (let motion = 6; motion < run.count - 3; motion += 4) {
           const point = run.point(motion, 1);
           let least = Infinity;
           for (let at = 0; at < edge.length; at += 6) {
             least = Math.min(least, Math.hypot(edge[at] - point[0], edge[at + 1] - point[1], edge[at + 2] - point[2]));
           }
           far.push(least);
         }
         return Math.max(...far);",
    );
    // Points of the edge stand every two degrees: 1.55 mm apart.
    assert!(real(&off) < 2.0, "{off} {status}");
    quiet(&browser);
}

/// Where the five axes stand behind a block, by adding up the increments of the text.
fn stands(text: &str, n: u32) -> Vec<(char, f64)> {
    let mut at: Vec<(char, f64)> = "XYZBC".chars().map(|letter| (letter, f64::NAN)).collect();
    let mut incremental = false;
    for line in text.lines() {
        let words: Vec<&str> = line.split(';').next().unwrap_or_default().split_whitespace().collect();
        // A block in machine coordinates says nothing of where the axes stand in the program's.
        if !words.contains(&"G53") {
            incremental = (incremental || words.contains(&"G91")) && !words.contains(&"G90");
            for (letter, stands) in &mut at {
                let word = words.iter().find_map(|word| word.strip_prefix(*letter)?.parse::<f64>().ok());
                *stands = word.map_or(*stands, |word| if incremental { *stands + word } else { word });
            }
        }
        if words.first() == Some(&format!("N{n}").as_str()) {
            assert!(at.iter().all(|(_, stands)| stands.is_finite()), "every axis has been moved: {at:?}");
            return at;
        }
    }
    panic!("no block N{n}");
}

#[test]
fn a_named_block_is_gone_to_and_its_coordinates_are_those_of_the_program() {
    if !chromium() {
        return;
    }
    let folder = folder();
    rodete(folder.path(), &["new", "impeller", "--case", "full"]);
    rodete(folder.path(), &["view", "impeller.xlsx"]);
    let page = folder.path().join("impeller.html");
    let browser = Browser::start(true);
    rodete(folder.path(), &["build", "impeller.xlsx", "--no-report"]);
    let text = fs::read_to_string(folder.path().join("impeller-out/impeller-blade.nc")).expect("the program");
    let mut searched = String::new();
    for n in [400, 640, 800] {
        let said = &browser.open(&page, &format!("goto=N{n}"))["said"];
        for (letter, at) in stands(&text, n) {
            let shown: f64 = said[letter.to_string()].as_str().expect("an axis").parse().expect("a number");
            assert!((shown - at).abs() < 5e-4, "N{n} {letter}: {shown} against {at}");
            if n == 640 && letter == 'X' {
                searched = format!("{at:.3}");
            }
        }
    }
    // The same by typing into the search field.
    browser.open(&page, "");
    browser.click("#wanted");
    browser.keys(&["N", "6", "4", "0", "\u{E007}"]);
    assert_eq!(browser.status()["said"]["X"], searched.as_str());
    quiet(&browser);
    // In inches where the program counts in them, and with the start of the first cut in view.
    fs::write(folder.path().join("inch.ngc"), "G20 G90\nG0 X2 Y1\nG1 X0.5 F10\nM2\n").expect("a program");
    rodete(folder.path(), &["view", "inch.ngc"]);
    // The block that says so is a step of its own.
    let inch = browser.open(&folder.path().join("inch.html"), "step=3");
    assert_eq!([&inch["said"]["X"], &inch["said"]["Y"], &inch["said"]["F"]], ["0.5000", "1.0000", "10.00"]);
    let seen = browser.run("return [camera.box[0][0], camera.box[1][0]].map((x) => Math.round(x * 100) / 100)");
    assert_eq!(seen, json!([12.7, 50.8]));
}

#[test]
fn a_program_that_moves_nothing_is_played_to_its_end_and_an_address_that_means_nothing_is_passed_over() {
    if !chromium() {
        return;
    }
    let folder = folder();
    fs::write(folder.path().join("still.ngc"), "G21 G90\nM3 S1000\nG4 P0\nM5\nM2\n").expect("a program");
    rodete(folder.path(), &["view", "still.ngc"]);
    let page = folder.path().join("still.html");
    let browser = Browser::start(true);
    let first = browser.open(&page, "step=one&time=two&view=toString&tab=none&program=9");
    assert_eq!((&first["cursor"], &first["preset"]), (&json!(0), &json!("iso")));
    assert_eq!(browser.run("return document.getElementById('blocks').hidden"), json!(false));
    assert!(real(&first["motions"]) > 1.0, "blocks without motion are steps: {first}");
    let end = browser.keys(&[" "]);
    assert_eq!((&end["playing"], &end["cursor"], &end["total"]), (&json!(false), &end["motions"], &json!(0)));
    // The same address once more leaves the section as it is.
    browser.open(&page, "view=section");
    browser.run("location.hash = 'view=section&step=1'");
    assert_eq!(browser.until("it has gone on", |now| real(&now["cursor"]) == 1.0)["section"], true);
    quiet(&browser);
}

#[test]
fn arcs_of_many_turns_are_as_round_as_those_of_one() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let text = "G21 G90 G94 F300\nG0 X10 Y0 Z0\nG2 X10 Y0 Z-50 I-10 J0 P50\nM2\n";
    fs::write(folder.path().join("helix.ngc"), text).expect("a program");
    rodete(folder.path(), &["view", "helix.ngc"]);
    let browser = Browser::start(true);
    browser.open(&folder.path().join("helix.html"), "");
    let off = browser.run(
        "let off = 0, seen = 0;
         for (let at = 5; at < path.length; at += 5) {
           if (path[at + 4] !== CLOCKWISE || path[at - 1] !== CLOCKWISE) continue;
           off = Math.max(off, 10 - Math.hypot(path[at] + path[at - 5], path[at + 1] + path[at - 4]) / 2);
           seen++;
         }
         return [off, seen];",
    );
    assert!(real(&off[0]) < 0.02 && real(&off[1]) > 2000.0, "{off}");
    quiet(&browser);
}

#[test]
fn behind_a_thread_the_feed_in_force_is_shown() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(true);
    // A Fanuc programs the lead with F; a Fagor's cycle says it beside the F.
    let fanuc = "G97 S500 M3 T0101\nG0 X60. Z5.\nG1 Z2. F0.2\nG32 Z-20. F1.5\nG0 Z5.\nM30\n";
    let fagor = "G95 G97 S500 T1 D1 M3\nG0 X30 Z6\nG1 Z5 F0.2\nG86 X24 Z2 Q24 R-35 I0.92 B0.25 E0.05 D1 L0.03 C1.5 J1 A30\nG0 Z9\nM30\n";
    for (dialect, text, behind) in [("fanuc-lathe-a", fanuc, "1.500"), ("fagor-8055-t", fagor, "0.200")] {
        fs::write(folder.path().join("thread.nc"), text).expect("a program");
        // Its alarms do not matter here.
        let mut command = Command::cargo_bin("rodete").expect("the binary");
        command.current_dir(folder.path()).args(["view", "thread.nc", "--stock", "D50xL100", "--dialect", dialect]);
        command.output().expect("the binary runs");
        let page = folder.path().join("thread.html");
        let feeds = [3, 5].map(|line| browser.open(&page, &format!("goto={line}"))["said"]["F"].clone());
        assert_eq!(feeds, ["0.200", behind], "{dialect}");
        let thread = browser.run("goTo(run.kind.indexOf(THREAD) + 1); draw(); return measured.said.F;");
        assert_eq!(thread, "1.500", "{dialect}");
    }
    quiet(&browser);
}

/// The F of G93, 1/min, had been shown as mm/min at the end of the program.
#[test]
fn a_feed_is_shown_only_under_the_code_that_it_was_given_under() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(true);
    let text = "G21 G90\nG94 G1 X5 F300\nG93 G1 X10 F2\nG94\nG0 X20\nG1 X30 F100\nG0 X0\nM2\n";
    fs::write(folder.path().join("part.ngc"), text).expect("a program");
    rodete(folder.path(), &["view", "part.ngc"]);
    let page = folder.path().join("part.html");
    let feeds = [2, 3, 5, 6, 7].map(|line| browser.open(&page, &format!("goto={line}"))["said"]["F"].clone());
    assert_eq!(feeds, ["300.0", "2.000", "–", "100.0", "100.0"]);
    quiet(&browser);
}

#[test]
fn keys_play_step_and_switch() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let page = turned(folder.path(), 1);
    let browser = Browser::start(true);
    browser.open(&page, "");
    assert_eq!(real(&browser.keys(&["\u{E014}", "\u{E014}"])["cursor"]), 2.0, "right arrow twice");
    assert_eq!(real(&browser.keys(&["\u{E012}"])["cursor"]), 1.0, "left arrow");
    let end = browser.keys(&["\u{E010}"]);
    assert_eq!(end["cursor"], end["motions"], "End");
    assert_eq!(real(&browser.keys(&["\u{E011}"])["cursor"]), 0.0, "Home");
    assert_eq!(browser.keys(&["\u{E015}"])["said"]["X"], "52.000", "down to the first block that moves");
    assert_eq!(browser.keys(&["l"])["language"], "en");
    let speed = real(&browser.status()["speed"]);
    assert!(real(&browser.keys(&["+"])["speed"]) > speed && real(&browser.keys(&["-"])["speed"]) == speed);
    assert_eq!(browser.keys(&["s"])["section"], true);
    assert_eq!(browser.keys(&["s"])["section"], false);
    assert_eq!(browser.keys(&["3"])["preset"], "plan");
    assert_eq!(browser.keys(&[" "])["playing"], true);
    browser.until("it has played on", |now| real(&now["cursor"]) > 3.0);
    assert_eq!(browser.keys(&[" "])["playing"], false);
    quiet(&browser);
}

#[test]
fn a_live_page_loads_itself_again_as_it_stood() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let page = folder.path().join("live.html");
    let mut live = Vec::new();
    rodete::view::write_live(&turned::scene(1), &mut live).expect("a page");
    fs::write(&page, live).expect("a page");
    let browser = Browser::start(true);
    browser.open(&page, "");
    browser.keys(&["3", "\u{E014}", "\u{E014}", "l"]);
    browser.run("window.stood = true");
    // A status waits for two frames: one that is asked for as the page goes is never answered.
    let went = (0..600).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(100));
        browser.run("return window.stood ?? false") == json!(false)
    });
    assert!(went, "it was not loaded again");
    let status = browser.until("it is drawn again", |status| status["loaded"].as_f64() > Some(0.0));
    assert_eq!((real(&status["cursor"]), &status["preset"], &status["language"]), (2.0, &json!("plan"), &json!("en")));
    // While it is used it stays.
    browser.run("window.stood = true; setInterval(() => dispatchEvent(new Event('pointermove')), 500)");
    std::thread::sleep(std::time::Duration::from_secs(7));
    assert_eq!(browser.run("return window.stood"), json!(true));
    quiet(&browser);
}

#[test]
fn both_languages_are_spoken() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let page = turned(folder.path(), 1);
    let browser = Browser::start(true);
    browser.open(&page, "");
    browser.click("#layers summary");
    let words =
        "return document.body.innerText + [...document.querySelectorAll('[aria-label]')].map((one) => one.ariaLabel)";
    let spanish = browser.run(words).to_string();
    for word in [
        "Bloques",
        "Avisos",
        "Velocidad",
        "Capas",
        "Herramienta",
        "Rejilla",
        "Pantalla de la máquina",
        "Planta (Z-X)",
        "Desde +X",
    ] {
        assert!(spanish.contains(word), "{word}: {spanish}");
    }
    browser.click("#language");
    browser.click("#tab-remarks");
    let english = browser.run(words).to_string();
    for word in
        ["Blocks", "Findings", "Speed", "Layers", "Tool", "Machine display", "L0114 · 2101", "the tool meets the jaw"]
    {
        assert!(english.contains(word), "{word}: {english}");
    }
    assert!(!english.contains("Bloques"));
    let nameless = browser.run(
        "return [...document.querySelectorAll('button, select, input')].filter((one) => !(one.ariaLabel || one.innerText || \
         one.closest('label'))).map((one) => one.outerHTML)",
    );
    assert_eq!(nameless, json!([]), "everything that can be pressed has a name");
    // An alarm leads to its block.
    let status = browser.click("#remarks button");
    assert_eq!((&status["line"], &status["said"]["Z"]), (&json!(20), &json!("-55.000")));
    quiet(&browser);
}

#[test]
fn the_display_of_a_turning_says_what_is_in_force_at_blocks_without_motion() {
    if !chromium() {
        return;
    }
    let folder = folder();
    rodete(folder.path(), &["new", "lathe", "shaft.xlsx", "--case", "shaft"]);
    rodete(folder.path(), &["view", "shaft.xlsx"]);
    let page = folder.path().join("shaft.html");
    let browser = Browser::start(true);
    let said =
        |fragment: &str, what: &str| browser.open(&page, fragment)["said"][what].as_str().unwrap_or("").to_owned();
    // Before the first block the turret stands at its reference point, and nothing runs.
    assert_eq!([said("time=0", "X"), said("time=0", "Z"), said("time=0", "S")], ["230.000", "151.000", "0"]);
    assert!(said("time=0", "cells").starts_with("M5 M9"));
    // The first rapid motion is on its way, each axis at its own rate: X, which has less to go, is there first.
    let [x, z] = ["X", "Z"].map(|axis| said("time=0.3", axis).parse::<f64>().expect("a number"));
    assert!(x == 54.0 && 5.0 < z && z < 150.0, "{x} {z}");
    let early: f64 = said("time=0.1", "X").parse().expect("a number");
    assert!(54.0 < early && early < 230.0, "{early}");
    assert_eq!([said("goto=N200", "T"), said("goto=N195", "T")], ["5", "4"]);
    assert!(said("goto=N155", "cells").contains("G1 G4"), "a dwell leaves the motion code in force");
    assert!(said("time=9999", "cells").starts_with("M5 M9") && said("time=9999", "S") == "0");
    quiet(&browser);
}

#[test]
fn the_x_of_a_lathe_points_to_its_turret_down_in_front_of_the_axis_and_up_behind_it() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(true);
    for (up, sign) in [(false, -1.0), (true, 1.0)] {
        let mut scene = turned::scene(1);
        scene.programs[0].turning.as_mut().expect("a turning").x_up = up;
        let page = folder.path().join(format!("{up}.html"));
        fs::write(&page, rodete::view::html(&scene)).expect("a page");
        // Z is to the right from every side; the eye of the views from the turret is on its side of the axis.
        for (view, along) in [("plan", 0.0), ("above", 1.0), ("iso", 0.4)] {
            browser.open(&page, &format!("view={view}"));
            let of = |axis: &str, at: usize| real(&browser.run(&format!("return camera.axes().{axis}[{at}];")));
            assert!(of("right", 2) > 0.7, "{view}");
            assert!(sign * of("up", 0) >= if view == "above" { -1e-9 } else { 0.8 }, "{view} {up}");
            assert!(of("eye", 0).abs() >= along - 1e-9 && of("eye", 0) >= -1e-9, "{view} {up}");
        }
        drawn(&browser, &format!("turning-x-{}", if up { "up" } else { "down" }));
    }
    quiet(&browser);
}

#[test]
fn metal_is_turned_away_as_the_program_goes_on() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let page = turned(folder.path(), 1);
    let browser = Browser::start(true);
    let status = browser.open(&page, "goto=N40&view=section");
    assert_eq!(status["said"]["X"], "44.000");
    assert!(status["said"]["cells"].as_str().expect("cells").starts_with("M3 M8"), "{status}");
    drawn(&browser, "turning-section");
    // The radius of the metal halfway along the bar, from the pieces that are drawn: before, while and after it is cut.
    let radius = |motion: usize, part: f64, z: f64| {
        real(&browser.run(&format!(
            "const pieces = run.metal.pieces({motion}, {part}, run.point({motion}, {part}), run.heading({motion}, {part}));
             let most = 0;
             for (let at = 0; at < pieces.length; at += 8) {{
               const [z0, r0, z1, r1] = pieces.subarray(at, at + 4);
               if (z0 !== z1 && Math.min(z0, z1) <= {z} && {z} <= Math.max(z0, z1)) most = Math.max(most, r0 + (r1 - r0) * ({z} - z0) / (z1 - z0));
             }}
             return most;"
        )))
    };
    let cut = 2;
    assert_eq!([radius(cut, 0.0, -30.0), radius(cut, 1.0, -30.0)], [25.0, 22.0]);
    // N40 goes from z = 2 to −60: at a half it stands at −29.
    assert_eq!([radius(cut, 0.5, -28.0), radius(cut, 0.5, -30.0)], [22.0, 25.0]);
    let all = real(&status["motions"]);
    for (fragment, name) in [
        ("time=40&view=plan".to_owned(), "turning"),
        (format!("step={}&view=iso", all - 1.0), "turning-iso"),
        ("goto=N170&view=free&lang=en".to_owned(), "turning-groove"),
    ] {
        browser.open(&page, &fragment);
        drawn(&browser, name);
    }
    // Parted off, nothing is left between the part and the stub.
    assert_eq!(radius(turned::PARTED, 1.0, -56.0), 0.0);
    // The piece is shown from then on.
    let piece =
        |motion: usize, part: f64| browser.run(&format!("return run.metal.piece({motion}, {part})?.length > 0"));
    let seen =
        [(turned::PARTED, 0.9), (turned::PARTED, 1.0), (turned::PARTED + 1, 0.0)].map(|(at, part)| piece(at, part));
    assert_eq!(seen, [json!(false), json!(true), json!(true)]);
    // Going back gives the bar again.
    assert_eq!(real(&browser.keys(&["\u{E011}"])["cursor"]), 0.0);
    assert_eq!(radius(0, 0.0, -30.0), 25.0);
    quiet(&browser);
}

#[test]
fn the_page_fits_a_phone_and_the_dark() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(true);
    let turned = turned(folder.path(), 1);
    let impeller = page_of(folder.path(), "impeller");
    for (page, name, fragment) in [(&turned, "phone-turning", "time=40"), (&impeller, "phone-impeller", "step=60")] {
        browser.resize(360, 740);
        browser.open(page, fragment);
        let wide = browser.run("return [document.documentElement.scrollWidth, innerWidth]");
        assert_eq!(wide, json!([360, 360]), "nothing hangs over");
        let small = browser.run(
            "return ['view', 'list', 'play', 'scrub', 'readout'].filter((id) => {
               const box = document.getElementById(id).getBoundingClientRect();
               return box.width < 30 || box.height < 20 || box.right > innerWidth || box.bottom > innerHeight;
             })",
        );
        assert_eq!(small, json!([]), "all that matters is in view");
        browser.picture(&picture(name), STAGE);
    }
    // Two fingers that part make it larger.
    let half = real(&browser.run("return camera.half"));
    let touch = |kind: &str, apart: f64| {
        let points = if kind == "touchEnd" {
            json!([])
        } else {
            json!([{ "x": 180.0 - apart, "y": 180, "id": 0 }, { "x": 180.0 + apart, "y": 180, "id": 1 }])
        };
        browser.developer("Input.dispatchTouchEvent", &json!({ "type": kind, "touchPoints": points }));
    };
    touch("touchStart", 30.0);
    touch("touchMove", 60.0);
    touch("touchEnd", 0.0);
    browser.status();
    let zoomed = real(&browser.run("return camera.half"));
    assert!((zoomed * 2.0 / half - 1.0).abs() < 0.2, "{half} {zoomed}");
    let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": "dark" }] });
    browser.developer("Emulation.setEmulatedMedia", &media);
    browser.resize(840, 560);
    browser.open(&turned, "time=60&view=iso");
    let shape = browser.run("const view = document.getElementById('view'); return view.width * view.clientHeight - view.height * view.clientWidth");
    assert_eq!(shape, json!(0), "a round part stays round when the window changes");
    let dark = browser.picture(&picture("dark-turning"), STAGE);
    let light = |name: &str| dark.iter().filter(|(colour, _)| colour == name).map(|(_, count)| count).sum::<u64>();
    assert!(light("111") > 10_000 && light("fff") + light("eff") < 1000, "a dark ground: {:?}", &dark[..3]);
    quiet(&browser);
}

#[test]
fn without_webgl_a_plain_drawing_takes_its_place() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let browser = Browser::start(false);
    for (page, name) in
        [(turned(folder.path(), 1), "plain-turning"), (page_of(folder.path(), "impeller"), "plain-impeller")]
    {
        let status = browser.open(&page, "step=9");
        assert_eq!(status["renderer"], "2d");
        drawn(&browser, name);
        let errors: Vec<_> = browser.console().into_iter().filter(|line| !line.contains("WebGL")).collect();
        assert_eq!(errors, Vec::<String>::new());
    }
}

#[test]
fn a_hundred_thousand_motions_are_gone_through_without_waiting() {
    if !chromium() {
        return;
    }
    let folder = folder();
    let mut program = String::from("G21 G90 G94 F1200\n");
    for at in 0..100_000_u32 {
        let (x, y) = (at % 317, at / 317);
        program.push_str(&format!("N{} G1 X{}.{:03} Y{}.5 Z-{}.25\n", at + 1, x, at % 1000, y, at % 7));
    }
    program.push_str("M2\n");
    fs::write(folder.path().join("milled.ngc"), program).expect("a program");
    rodete(folder.path(), &["view", "milled.ngc"]);
    let browser = Browser::start(true);
    for page in [turned(folder.path(), 5300), folder.path().join("milled.html")] {
        let status = browser.open(&page, "");
        assert!(real(&status["motions"]) >= 100_000.0, "{status}");
        assert!(real(&status["loaded"]) < 15_000.0, "{status}");
        // To the end, into the middle, and back: each within the time of a few frames.
        let seeks = browser.run(
            "return [1, 0.5, 0.51, 0.9, 0.1, 0].map((share) => {
               const began = performance.now();
               goTo(Math.floor(run.count * share));
               draw();
               return Math.round((performance.now() - began) * 10) / 10;
             });",
        );
        assert!(seeks.as_array().into_iter().flatten().all(|time| real(time) < 1500.0), "{seeks}");
        // What the page itself takes for a frame; the rest is the work of the graphics, here of software.
        let frames: Vec<f64> = (0..5_u32)
            .map(|at| {
                browser.run(&format!("goTo({})", 5000.4 + 0.37 * f64::from(at)));
                real(&browser.status()["frame"])
            })
            .collect();
        let mut sorted = frames.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(sorted[2] < 100.0, "{frames:?}");
        // The last line is shown and can be clicked.
        let last = browser.open(&page, "goto=100000");
        let seen = browser.run("return [...document.querySelectorAll('.row.now')].map((row) => row.textContent)");
        if real(&last["lines"]) > 100_000.0 {
            assert!(seen[0].as_str().expect("a row").starts_with("100000N99999 G1"), "{seen}");
        }
        let (bytes, name) = (fs::metadata(&page).expect("a page").len(), page.file_name().expect("a name").display());
        println!("{name}: {bytes} bytes, loaded in {} ms, seeks {seeks} ms, frames {frames:?} ms", status["loaded"]);
    }
}
