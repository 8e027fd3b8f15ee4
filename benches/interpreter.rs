//! Reading programs back: five-axis lines and arcs with R, in lines a second.

#![allow(clippy::disallowed_methods, reason = "benchmarks read files and the clock")]

use std::fmt::Write as _;
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rodete::gcode::control::LINUXCNC;
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::machine::axis::Pose;
use rodete::proof::account::Account;

const LINES: u32 = 20_000;

/// Numbers without a pattern, the same in every run.
struct Numbers(u64);

impl Numbers {
    /// A number in thousandths, up to `most` in size.
    fn next(&mut self, most: i64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let thousandths = i64::try_from(self.0 >> 33).unwrap_or(0) % (2000 * most) - 1000 * most;
        f64::from(i32::try_from(thousandths).unwrap_or(0)) / 1000.0
    }
}

fn five_axes() -> String {
    let mut numbers = Numbers(1);
    let mut text = "G21 G90 G94 F500\n".to_owned();
    for n in 1..LINES {
        let [x, y, z, b, c] = [100, 100, 100, 90, 360].map(|most| numbers.next(most));
        let _ = writeln!(text, "N{n} G1 X{x:.3} Y{y:.3} Z{z:.3} B{b:.3} C{c:.3}");
    }
    text + "M2\n"
}

fn arcs() -> String {
    let mut numbers = Numbers(2);
    let mut text = "G21 G90 G94 F500\nG0 X0 Y0\n".to_owned();
    let mut at = [0.0, 0.0];
    for n in 2..LINES {
        let to = [numbers.next(50), numbers.next(50)];
        let [dx, dy] = [to[0] - at[0], to[1] - at[1]];
        let radius = (dx * dx + dy * dy).sqrt() / 2.0 + numbers.next(20).abs() + 0.001;
        let _ = writeln!(text, "G{} X{:.3} Y{:.3} R{radius:.3}", 2 + n % 2, to[0], to[1]);
        at = to;
    }
    text + "M2\n"
}

/// How many motions a program makes and what it comes to, as the command `verify` finds it.
fn read(text: &str) -> (u64, f64) {
    let mut account = Account::default();
    let mut before = Pose::default();
    for motion in Interpreter::over(text.as_bytes(), Setting::new(&LINUXCNC)).flatten() {
        account.take(&motion, &before);
        before = motion.machine;
    }
    (account.motions, account.feed_path)
}

fn interpreter(c: &mut Criterion) {
    let mut group = c.benchmark_group("lines read back");
    group.throughput(Throughput::Elements(u64::from(LINES)));
    for (name, text) in [("five axes", five_axes()), ("arcs with R", arcs())] {
        assert!(read(&text).0 > u64::from(LINES) - 10, "{name}: every line is a motion");
        group.bench_function(name, |b| b.iter(|| black_box(read(&text))));
    }
    group.finish();
}

criterion_group!(benches, interpreter);
criterion_main!(benches);
