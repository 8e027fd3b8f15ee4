//! LinuxCNC's own interpreter, `rs274` of the Debian package linuxcnc-uspace, as an independent judge of the programs in
//! its dialect. A black box: private HOME, fresh variable file, a deadline.

mod common;

use std::io::Write;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use rodete::parameter::Value;

/// True where rs274 is installed. Where it is not, says so loudly; in CI that is a failure.
fn rs274_is_here() -> bool {
    let here = Command::new("rs274").arg("-h").stdin(Stdio::null()).output().is_ok();
    if !here {
        // Not through the macros, whose output a passing test keeps to itself.
        let _ = writeln!(
            std::io::stderr(),
            "\n*** rs274 is not installed: programs are NOT JUDGED by LinuxCNC. Install linuxcnc-uspace. ***\n"
        );
        assert!(std::env::var_os("CI").is_none(), "rs274 is missing in CI");
    }
    here
}

/// The canonical motions of a program: true for a rapid move, and the six axes.
fn judge(program: &str) -> Result<Vec<(bool, [f64; 9])>, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("p.ngc"), program).unwrap();
    // The machine unit of the stand-alone interpreter is the inch.
    std::fs::write(path("t.tbl"), "T1 P1 Z0 D0.23622 ;\n").unwrap();
    let mut child = Command::new("rs274")
        .args(["-g", "-t"])
        .arg(path("t.tbl"))
        .arg("-v")
        .arg(path("fresh.var"))
        .arg(path("p.ngc"))
        .arg(path("out"))
        .env("HOME", folder.path())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if start.elapsed() > Duration::from_secs(30) {
            child.kill().unwrap();
            return Err("deadline".to_owned());
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    if !status.success() {
        let output = child.wait_with_output().unwrap();
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let canon = std::fs::read_to_string(path("out")).unwrap();
    Ok(canon
        .lines()
        .filter_map(|line| {
            let (call, rest) = line.split_once("STRAIGHT_")?.1.split_once('(')?;
            let mut axes = [0.0; 9];
            for (axis, number) in axes.iter_mut().zip(rest.trim_end_matches(')').split(',')) {
                *axis = number.trim().parse().ok()?;
            }
            Some((call == "TRAVERSE", axes))
        })
        .collect())
}

#[test]
fn linuxcnc_moves_as_planned() {
    if !rs274_is_here() {
        return;
    }
    for distance in ["G90", "G91"] {
        for (n, N, splitters) in [(40, 4, "yes"), (17, 3, "yes"), (80, 5, "no")] {
            let outcome = common::outcome(
                "full",
                &[
                    ("dialect", Value::Choice("linuxcnc")),
                    ("distance", Value::Choice(distance)),
                    ("n", Value::Whole(n)),
                    ("N", Value::Whole(N)),
                    ("splitters", Value::Choice(splitters)),
                ],
            );
            for program in outcome.programs.iter().filter(|program| program.key != "blank") {
                let motions = judge(&program.text()).unwrap();
                let mut planned = Vec::new();
                program.for_each_move(&mut |each| {
                    planned.push((each.path.rapid, each.to.differences(&rodete::machine::axis::Position::default())));
                });
                // Before the plan: two positioning blocks. G93 makes no motion, but a null move may be listed.
                let motions: Vec<_> = motions
                    .iter()
                    .enumerate()
                    .filter(|&(at, motion)| at == 0 || motions[at - 1].1 != motion.1)
                    .map(|(_, motion)| *motion)
                    .collect();
                let motions = &motions[motions.len() - planned.len()..];
                for (judged, planned) in motions.iter().zip(&planned) {
                    assert_eq!(judged.0, planned.0, "{}", program.key);
                    let miss = judged.1.iter().zip(planned.1).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    assert!(miss < 0.000_051, "{}: {judged:?} against {planned:?}", program.key);
                }
            }
        }
    }
}

#[test]
fn the_judge_refuses_what_is_wrong() {
    if rs274_is_here() {
        assert!(judge("G1 X1\nM2\n").is_err(), "a feed move without F");
        assert!(judge("G0 X1 M11 M13\nM2\n").is_err(), "codes of another control");
    }
}

#[test]
fn a_hostile_part_name_makes_no_move() {
    if !rs274_is_here() {
        return;
    }
    let program = |part: &str| {
        let outcome =
            common::outcome("full", &[("dialect", Value::Choice("linuxcnc")), ("part", Value::Line(part.to_owned()))]);
        judge(&common::program(&outcome, "blade")).unwrap()
    };
    assert_eq!(program("A)G0 Z-500 (x"), program("Impeller"));
    assert_eq!(program("A\nG0 Z-500\r;(MSG,%"), program("Impeller"));
}
