//! Rows that no input raises, raised by what is handed to the functions of the library that say them: a disk that answers, a
//! turning cycle, a blank and a tool for a simulation, a front of a sweep.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use rodete::finding::{Finding, Place, Refusal};
use rodete::gcode::in_force::InForce;
use rodete::gcode::interpreter::Refused;
use rodete::gcode::motion::{Motion, MotionKind, Thread};
use rodete::gcode::turning::Move;
use rodete::gcode::turning::finish::finish;
use rodete::gcode::turning::profile::{Element, Profile};
use rodete::gcode::turning::rough::{self, Rough};
use rodete::gcode::turning::thread_cycle::{Threading, thread};
use rodete::gcode::turning::trouble::Trouble;
use rodete::limits::{FRONT_DESIGNS, STOCK_SIZE};
use rodete::machine::axis::{Axis, Pose};
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::{Setup, Simulation};
use rodete::removal::turning::stock::Stock;
use rodete::removal::turning::tool::{Cutter, Hand, Holder, Tip, TurningTool};
use rodete::removal::turning::turret::Turret;
use rodete::store::{Disk, Existing, Folder, Set, Step, WrittenFile};
use rodete::sweep::front::{Candidate, front};
use rodete::sweep::ranking::{Counts, Ranked};
use rodete::text::Text;

/// What the system answers, by its numbers.
const EIO: i32 = 5;
const EBUSY: i32 = 16;
const EFBIG: i32 = 27;
const ENOSPC: i32 = 28;
const EROFS: i32 = 30;

/// What is told of files of these names, written into a folder on a disk.
fn delivered(place: &Path, disk: &Disk, names: &[&str]) -> Vec<Finding> {
    let write = || -> Result<Vec<WrittenFile>, Refusal> {
        let folder = Folder::open_on(place, disk)?;
        let mut set = Set::new(&folder, &[], Existing::Replace);
        for name in names {
            set.write(OsStr::new(name), |out| out.write_all(b"M30\n"))?;
        }
        set.commit()
    };
    write().unwrap_err().findings
}

/// What is told where the disk answers so to a step.
fn answering(step: Step, answer: i32) -> Vec<Finding> {
    let place = tempfile::tempdir().unwrap();
    let disk = Disk::watched(move |now, _| match now == step {
        true => Err(io::Error::from_raw_os_error(answer)),
        false => Ok(()),
    });
    delivered(place.path(), &disk, &["part.nc"])
}

/// What is told where this befalls the folder before the file comes under its name.
fn befalling(befalls: impl Fn(&Path) -> io::Result<()> + Send + Sync + 'static) -> Vec<Finding> {
    let place = tempfile::tempdir().unwrap();
    let disk = Disk::watched(move |now, path| if now == Step::Rename { befalls(path) } else { Ok(()) });
    delivered(place.path(), &disk, &["part.nc"])
}

/// What is told where the second file of a delivery fails, and so does all that comes then.
fn stuck() -> Vec<Finding> {
    let place = tempfile::tempdir().unwrap();
    ["a.nc", "b.nc"].into_iter().for_each(|name| fs::write(place.path().join(name), "before").unwrap());
    let failed = AtomicBool::new(false);
    let disk = Disk::watched(move |now, path| {
        if now == Step::Rename && path.ends_with("b.nc") {
            failed.store(true, Ordering::Relaxed);
        }
        if failed.load(Ordering::Relaxed) { Err(io::Error::from_raw_os_error(EIO)) } else { Ok(()) }
    });
    delivered(place.path(), &disk, &["a.nc", "b.nc"])
}

/// What is told of a workbook that is another by now than the one that was read.
fn changed_book() -> Vec<Finding> {
    let place = tempfile::tempdir().unwrap();
    let book = place.path().join("impeller.xlsx");
    fs::write(&book, "now").unwrap();
    let folder = Folder::open(place.path()).unwrap();
    let mut set = Set::new(&folder, &[&book], Existing::Replace);
    set.replace(&book, b"as it was read", b"with the results").unwrap();
    let told = set.commit().unwrap_err().findings;
    assert_eq!(fs::read(book).unwrap(), b"now");
    told
}

/// What is told of contents that give up for a reason of their own.
fn not_composed() -> Vec<Finding> {
    let place = tempfile::tempdir().unwrap();
    let folder = Folder::open(place.path()).unwrap();
    let mut set = Set::new(&folder, &[], Existing::Replace);
    set.write(OsStr::new("part.xlsx"), |_| Err("a sheet of 1048577 rows")).unwrap_err().findings
}

/// What is told of a cycle.
fn cycle(moves: Result<Vec<Move>, Box<Trouble>>) -> Vec<Finding> {
    vec![Refused::from(*moves.unwrap_err()).into()]
}

/// A contour of one block.
fn contour(arc: Option<([f64; 2], bool)>) -> Profile {
    Profile { start: [25.0, 5.0], elements: vec![Element { to: [15.0, -5.0], arc, rapid: false, line: 2 }] }
}

/// A bar of D 50 with one part of it other.
fn stock(change: impl FnOnce(&mut Stock)) -> Vec<Finding> {
    let mut stock = Stock::bar(50.0, 100.0);
    change(&mut stock);
    stock.faults()
}

/// A set-up with a tool for threads of this depth.
fn setup(depth: f64) -> Setup {
    let tool = TurningTool {
        name: Text::same("60°"),
        cutter: Cutter::Threader { angle: 60.0, nose: 0.06, depth, leads: [0.5, 3.0] },
        hand: Hand::Right,
        tip: Tip::Outside,
        holder: Holder::Shank { width: 25.0, length: 60.0 },
        turns: None,
        overhang: [60.0, 0.0],
    };
    let turret = Turret { tools: [(4, tool)].into(), ..Turret::default() };
    Setup::new(Lathe::default(), Stock::bar(50.0, 100.0), turret)
}

fn refused(setup: Setup) -> Vec<Finding> {
    Simulation::new(setup).unwrap_err().findings
}

/// What is told of a thread of this lead along the surface of a bar.
fn threaded(lead: f64) -> Vec<Finding> {
    let setup = setup(2.5);
    let zero = setup.stock.zero(&setup.lathe);
    let pose = |x: f64, z: f64| {
        let mut pose = Pose::default();
        pose.set(Axis::X, x);
        pose.set(Axis::Z, z);
        pose
    };
    let kind = MotionKind::Thread(Thread { lead, change: 0.0, angle: 0.0 });
    let machine = pose(27.0 + 60.0, -20.0 + zero);
    let motion =
        Motion { line: 5, n: None, kind, from: pose(27.0, 5.0), to: pose(27.0, -20.0), machine, seconds: None };
    let control = InForce { tool: 4, offset: 4, system: 1, ..InForce::default() };
    let step = Simulation::new(setup).unwrap().take(&motion, &control);
    step.alarms
        .iter()
        .map(|alarm| alarm.cause.row().at(Place::Line { line: alarm.line, columns: Vec::new() }))
        .collect()
}

/// What is told of a front of so many designs.
fn front_of(count: usize) -> Vec<Finding> {
    let line = |at: u32| Candidate { id: at.into(), costs: vec![f64::from(at), -f64::from(at)] };
    let (front, cut) = front((0_u32..).take(count).map(line).collect());
    let ranked = Ranked { front, cut, best: Vec::new(), counts: Counts::default(), why: Vec::new() };
    ranked.told().into_iter().collect()
}

/// What is told of what an example's key stands for; none where it is another's.
pub fn told(key: &str) -> Option<Vec<Finding>> {
    let rough = Rough { depth: f64::INFINITY, retract: 1.0, U: 0.0, W: 0.0, feed: None, both_axes: None };
    let threading = Threading {
        finishing: 1,
        chamfer: 0,
        angle: 60.0,
        least: 0.1,
        allowance: 0.0,
        to: [14.0, -20.0],
        taper: 0.0,
        height: 1.0,
        first: 0.4,
        lead: 0.0,
    };
    Some(match key {
        "given-disk-full" => answering(Step::Write, ENOSPC),
        "given-disk-limit" => answering(Step::Write, EFBIG),
        "given-disk-read-only" => answering(Step::Create, EROFS),
        "given-disk-busy" => answering(Step::Rename, EBUSY),
        "given-folder-gone" => befalling(|path| fs::remove_dir_all(path.parent().unwrap())),
        "given-folder-there" => befalling(|path| fs::create_dir(path)),
        "given-disk-stuck" => stuck(),
        "given-book-changed" => changed_book(),
        "given-name-twice" => {
            let place = tempfile::tempdir().unwrap();
            delivered(place.path(), &Disk::default(), &["part.nc", "part.nc"])
        }
        "given-not-composed" => not_composed(),
        "given-no-contour" => cycle(finish(&Profile::default())),
        "given-arc-first" => cycle(finish(&contour(Some(([15.0, 5.0], true))))),
        "given-endless-depth" => cycle(rough::axial(&contour(None), &rough)),
        "given-cycle-lead" => cycle(thread([17.0, 5.0], &threading)),
        "given-thread-lead" => threaded(0.0),
        "given-stock-diameter" => stock(|stock| stock.diameter = 2.0 * STOCK_SIZE),
        "given-stock-length" => stock(|stock| stock.length = 2.0 * STOCK_SIZE),
        "given-stock-bore" => stock(|stock| stock.bore = stock.diameter),
        "given-stock-overhang" => stock(|stock| stock.overhang = 2.0 * stock.length),
        "given-stock-facing" => stock(|stock| stock.facing = stock.overhang),
        "given-tolerance" => refused(Setup { tolerance: 1.0, ..setup(2.5) }),
        "given-tool" => refused(setup(-2.5)),
        "given-front" => front_of(FRONT_DESIGNS + 1),
        _ => return None,
    })
}

/// The neighbours of what is refused are taken.
#[test]
fn what_is_handed_over_is_sound_but_for_what_it_is_refused_for() {
    assert!(stock(|_| {}).is_empty());
    assert!(Simulation::new(setup(2.5)).is_ok());
    assert!(threaded(1.5).iter().all(|finding| finding.code() != "L0141"));
    assert!(front_of(FRONT_DESIGNS).is_empty());
}
