//! The calibration of one serial number, as a table of its own: the file that a maker's driver writes, beside the nominal table.
//!
//! Two forms are read: a pose for every link (`kinematics:` with `x, y, z, roll, pitch, yaw`, each in the link before, turning about z), and
//! deviations of the four columns (`delta_theta`, `delta_a`, `delta_d`, `delta_alpha`). Rows of nearly parallel axes as makers write them may hold
//! lengths of hundreds of metres; here the frames are placed anew, so that all lengths stay those of the arm.

use super::axes::{Axis, PlacedAxes};
use super::frames;
use super::problem::Problem;
use super::rounding::Limits;
use super::sheet::Sheet;
use super::space::{Pose, Rotation, minus, norm};
use super::write;
use super::yaml::{self, Entry};
use super::{Imported, Options, Rounding, describe};
use crate::chain::table::parse;
use crate::chain::{AngleCell, Bound, ChainSpec, Convention, LengthCell, MotionSpec, Nominal, Role};
use crate::diagnostic::lex;

/// A calibration file as a table. `nominal`: the text of the nominal table.
///
/// # Errors
/// With the line of the calibration file; where the arms differ too much to be one.
pub(super) fn read(text: &str, nominal: &str, options: &Options) -> Result<Imported, Problem> {
    let spec = table(nominal)?;
    let entries = yaml::read(text)?;
    let rows = numbers(&spec)?;
    let mut notes = Vec::new();
    let deltas = |name: &str| entries.iter().find(|e| e.path.last().is_some_and(|n| n == name));
    let poses = link_poses(&entries)?;
    let metres = spec.settings.unit.metres.to_f64();
    let (base, tool) = (product(&spec, &spec.base)?, product(&spec, &spec.tool)?);
    let steps: Vec<(Pose, bool)> = if poses.is_empty() {
        let mut rows = rows.clone();
        let mut found = false;
        for (name, column, scale) in [
            ("delta_theta", 3, 1.0),
            ("delta_a", 1, 1.0 / metres),
            ("delta_d", 2, 1.0 / metres),
            ("delta_alpha", 0, 1.0),
        ] {
            let Some(entry) = deltas(name) else { continue };
            found = true;
            if entry.values.len() != rows.len() {
                let text = format!("`{name}` has {} values, the table {} rows", entry.values.len(), rows.len());
                return Err(Problem::at((entry.line, 1), text));
            }
            for (row, delta) in rows.iter_mut().zip(&entry.values) {
                row.columns[column] += delta * scale;
            }
        }
        if !found {
            return Err(Problem::new(
                "this is no calibration: neither link poses (`kinematics:` with x, y, z, roll, pitch, yaw) nor `delta_theta`, ...",
            ));
        }
        transforms(&spec, &rows, &base, &tool)
    } else {
        if poses.len() != spec.rows.iter().filter(|r| r.moves.is_some()).count() {
            let text = format!("the file has the poses of {} links, the table moves otherwise", poses.len());
            return Err(Problem::new(text).help("is this the calibration of another arm?"));
        }
        // Poses are in metres.
        let scaled = |p: &Pose| Pose { r: p.r, p: p.p.map(|x| x / metres) };
        let mut list: Vec<(Pose, bool)> = poses.iter().map(|p| (scaled(p), true)).collect();
        list.push((tool, false));
        // Makers count from the robot's base or from one turned by half a turn.
        let turned = Pose::turned(2, std::f64::consts::PI);
        let away = |start: &Pose| {
            let mut list = list.clone();
            list[0].0 = base.times(start).times(&list[0].0);
            (distance(&list, &transforms(&spec, &rows, &base, &tool)), list)
        };
        let (straight, half) = (away(&Pose::IDENTITY), away(&turned));
        let best = if straight.0 <= half.0 { straight } else { half };
        best.1
    };
    let nominal_steps = transforms(&spec, &rows, &base, &tool);
    let off = distance(&steps, &nominal_steps);
    let reach: f64 = nominal_steps.iter().map(|s| norm(s.0.p)).sum();
    if off > 0.05 * reach {
        let text = format!(
            "the calibrated arm is off the nominal one by {off:.3} {} at a sample pose",
            spec.settings.unit.name
        );
        return Err(Problem::new(text).help("is this the calibration of another arm?"));
    }
    notes.push(format!(
        "the calibrated tip is off the nominal one by at most {off:.2e} {} (at sample poses)",
        spec.settings.unit.name
    ));
    let arm = arm(&spec, &steps, reach);
    let rows = frames::build(&arm);
    let convention = options.convention.unwrap_or(spec.convention);
    let mut sheet = Sheet {
        docs: vec![format!("{}, calibrated.", spec.name)],
        name: options.name.clone().unwrap_or_else(|| format!("{}Calibrated", spec.name)),
        convention,
        unit: (spec.settings.unit.name != "m").then_some(spec.settings.unit.name),
        base: write::motions(&rows.base),
        tool: write::motions(&rows.tool),
        settings: Vec::new(),
        rows: write::rows(&arm, &rows, convention),
    };
    for row in &mut sheet.rows {
        let bounds = spec.rows.iter().filter(|r| r.moves.is_some()).zip(&arm.axes).find(|(_, a)| a.name == row.label);
        if let Some((r, _)) = bounds
            && let Some((low, high)) = &r.range
        {
            row.range = format!("{}..={}", bound(low), bound(high));
        }
    }
    describe::finish(sheet, notes)
}

fn bound(b: &Bound) -> String {
    match b {
        Bound::HalfTurns(x) => format!("{}deg", x.to_f64() * 180.0),
        Bound::Radians(x) => format!("{}rad", x.to_f64()),
        Bound::Length(x) => format!("{}", x.to_f64()),
    }
}

/// The nominal table.
fn table(text: &str) -> Result<ChainSpec, Problem> {
    let tokens = lex(text).map_err(|e| Problem::new(format!("the nominal table: {}", e.draw(text, "nominal"))))?;
    let parsed = parse(tokens);
    parsed.spec.ok_or_else(|| Problem::new(format!("the nominal table: {}", parsed.errors.draw(text, "nominal"))))
}

/// A row of the nominal table in numbers: alpha, a, d, theta.
#[derive(Clone, Debug)]
struct Row {
    columns: [f64; 4],
    turns: Option<bool>,
}

fn numbers(spec: &ChainSpec) -> Result<Vec<Row>, Problem> {
    spec.rows
        .iter()
        .map(|row| {
            let columns =
                [angle(spec, &row.alpha)?, length(spec, &row.a)?, length(spec, &row.d)?, angle(spec, &row.theta)?];
            Ok(Row { columns, turns: row.moves.as_ref().map(|m| m.revolute) })
        })
        .collect()
}

fn parameter(spec: &ChainSpec, i: usize) -> Result<f64, Problem> {
    let value = spec.parameters.get(i).and_then(|p| match &p.role {
        Role::Constant(v) | Role::Field(Some(v)) => Some(v),
        Role::Field(None) => None,
    });
    match value {
        Some(Nominal::Length(x)) => Ok(x.to_f64()),
        Some(Nominal::Angle(cell)) => Ok(cell.radians()),
        None => Err(Problem::new("the nominal table has a name without a nominal value")),
    }
}

fn length(spec: &ChainSpec, cell: &LengthCell) -> Result<f64, Problem> {
    let term = |(k, factors): &(crate::algebra::Rational, Vec<usize>)| {
        factors.iter().try_fold(k.to_f64(), |x, i| Ok(x * parameter(spec, *i)?))
    };
    cell.terms.iter().map(term).sum()
}

fn angle(spec: &ChainSpec, cell: &AngleCell) -> Result<f64, Problem> {
    let symbols = cell.symbols.iter().map(|(i, k)| Ok(f64::from(*k) * parameter(spec, *i)?));
    Ok(cell.radians() + symbols.sum::<Result<f64, Problem>>()?)
}

fn product(spec: &ChainSpec, motions: &[MotionSpec]) -> Result<Pose, Problem> {
    motions.iter().try_fold(Pose::IDENTITY, |pose, m| {
        Ok(pose.times(&match m {
            MotionSpec::Translate(axis, x) => Pose::shifted(*axis, length(spec, x)?),
            MotionSpec::Rotate(axis, x) => Pose::turned(*axis, angle(spec, x)?),
            // What the program sets stays out of the table.
            MotionSpec::Pose(_) => Pose::IDENTITY,
        }))
    })
}

/// What stands before each joint (about and along z, turning or sliding), and the tip behind the last one (marked false by a fixed end).
fn transforms(spec: &ChainSpec, rows: &[Row], base: &Pose, tool: &Pose) -> Vec<(Pose, bool)> {
    let mut list = Vec::new();
    let mut now = *base;
    for row in rows {
        let [alpha, a, d, theta] = row.columns;
        let across = Pose::shifted(0, a).times(&Pose::turned(0, alpha));
        let along = Pose::turned(2, theta).times(&Pose::shifted(2, d));
        if spec.convention == Convention::Modified {
            now = now.times(&across);
        }
        if let Some(turns) = row.turns {
            list.push((now, turns));
            now = Pose::IDENTITY;
        }
        now = now.times(&along);
        if spec.convention == Convention::Standard {
            now = now.times(&across);
        }
    }
    list.push((now.times(tool), false));
    list
}

/// The largest distance of the tips at sample poses.
fn distance(a: &[(Pose, bool)], b: &[(Pose, bool)]) -> f64 {
    let tip = |steps: &[(Pose, bool)], sample: usize| {
        let last = steps.len() - 1;
        steps.iter().enumerate().fold(Pose::IDENTITY, |pose, (i, (before, turns))| {
            let x = ((i * 5 + sample * 3) as f64).sin() * if *turns { 2.0 } else { 0.0 };
            let pose = pose.times(before);
            if i == last || !turns { pose } else { pose.times(&Pose::turned(2, x)) }
        })
    };
    (0..6).map(|k| norm(minus(tip(a, k).p, tip(b, k).p))).fold(0.0, f64::max)
}

/// A link's path in the file, its x, y, z, roll, pitch and yaw as far as they are given, and its first line.
type LinkNumbers<'a> = (&'a [String], [Option<f64>; 6], usize);

/// The poses of links, in the order of the file.
fn link_poses(entries: &[Entry]) -> Result<Vec<Pose>, Problem> {
    const NAMES: [&str; 6] = ["x", "y", "z", "roll", "pitch", "yaw"];
    let mut links: Vec<LinkNumbers<'_>> = Vec::new();
    for entry in entries {
        let Some((name, link)) = entry.path.split_last() else { continue };
        let (Some(k), [x]) = (NAMES.iter().position(|n| n == name), entry.values.as_slice()) else { continue };
        match links.iter_mut().find(|l| l.0 == link) {
            Some(known) => known.1[k] = Some(*x),
            None => {
                let mut values = [None; 6];
                values[k] = Some(*x);
                links.push((link, values, entry.line));
            }
        }
    }
    links
        .into_iter()
        .map(|(link, values, line)| {
            let mut numbers = [0.0; 6];
            for ((x, value), name) in numbers.iter_mut().zip(values).zip(NAMES) {
                *x = value
                    .ok_or_else(|| Problem::at((line, 1), format!("link `{}` has no `{name}`", link.join("."))))?;
            }
            let [x, y, z, roll, pitch, yaw] = numbers;
            if [x, y, z].iter().any(|v| v.abs() > 100.0) {
                return Err(Problem::at((line, 1), format!("link `{}` is farther away than 100 m", link.join("."))));
            }
            Ok(Pose { r: Rotation::rpy([roll, pitch, yaw]), p: [x, y, z] })
        })
        .collect()
}

/// The axes in space.
fn arm(spec: &ChainSpec, steps: &[(Pose, bool)], reach: f64) -> PlacedAxes {
    let limits = Limits::new(Rounding::AsWritten, reach);
    let mut arm = PlacedAxes {
        axes: Vec::new(),
        end: Pose::IDENTITY,
        written: Vec::new(),
        written_end: Pose::IDENTITY,
        limits,
        rounded: Vec::new(),
        notes: Vec::new(),
    };
    let labels: Vec<String> = spec
        .rows
        .iter()
        .filter(|r| r.moves.is_some())
        .enumerate()
        .map(|(i, r)| r.label.clone().unwrap_or_else(|| format!("joint_{}", i + 1)))
        .collect();
    let mut here = Pose::IDENTITY;
    for (i, (before, turns)) in steps.iter().enumerate() {
        here = here.times(before);
        if let Some(name) = labels.get(i) {
            arm.axes.push(Axis {
                name: name.clone(),
                turns: *turns,
                p: here.p,
                z: here.r.0[2],
                limits: None,
                motors: vec![(i, 1.0)],
                at_zero: 0.0,
            });
            arm.written.push((*before, [0.0, 0.0, 1.0]));
        } else {
            arm.written_end = *before;
        }
    }
    arm.end = here;
    arm
}
