//! A complete reachability map of a UR5e: for every cell of a grid, how many of many orientations the tool flange can take there.
//!
//! `cargo run --release -p generated-examples --example reachability -- [STEP [ORIENTATIONS [FILE]]]`
//!
//! The step of the grid is in metres (default 0.025), the file a coloured point cloud (PLY, default `reachability.ply`) that MeshLab, Blender or
//! CloudCompare open. The half in front is left out of the file, so that one sees into the map: red cells are reached with few orientations, blue ones with all.

#![allow(clippy::print_stdout)] // an example shows its results

use std::f64::consts::{PI, SQRT_2};
use std::fs::File;
use std::io::{BufWriter, Write};
use std::time::Instant;

use dh_robot::dh_robot;
use dh_robot::nalgebra::{IsometryMatrix3, Quaternion, Rotation3, Translation3, UnitQuaternion};
use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

dh_robot! {
    /// Universal Robots UR5e, the maker's table.
    pub struct Ur5e;

    convention = standard;
    unit = m;

    | joint | theta | d       | a       | alpha  | range            |
    |-------|-------|---------|---------|--------|------------------|
    |   1   | q1    | 162.5mm | 0       |  90deg | -360deg..=360deg |
    |   2   | q2    | 0       | -425mm  |   0    | -360deg..=360deg |
    |   3   | q3    | 0       | -392.2mm|   0    | -180deg..=180deg |
    |   4   | q4    | 133.3mm | 0       |  90deg | -360deg..=360deg |
    |   5   | q5    | 99.7mm  | 0       | -90deg | -360deg..=360deg |
    |   6   | q6    | 99.6mm  | 0       |   0    | -360deg..=360deg |
}

/// Beyond this distance from the base's origin the arm reaches nothing: the sum of its lengths.
const REACH: f64 = 1.32;

/// Orientations that are spread evenly over all of them (Alexa, Super-Fibonacci Spirals, CVPR 2022).
fn orientations(count: usize) -> Vec<Rotation3<f64>> {
    const PSI: f64 = 1.533_751_168_755_204_3;
    let one = |i: usize| {
        let s = i as f64 + 0.5;
        let t = s / count as f64;
        let ((sa, ca), (sb, cb)) = ((2.0 * PI * s / SQRT_2).sin_cos(), (2.0 * PI * s / PSI).sin_cos());
        let (r, rest) = (t.sqrt(), (1.0 - t).sqrt());
        UnitQuaternion::from_quaternion(Quaternion::new(rest * cb, r * sa, r * ca, rest * sb)).to_rotation_matrix()
    };
    (0..count).map(one).collect()
}

/// What a cell was found to be.
struct Cell {
    place: [f64; 3],
    /// Orientations with a solution in the ranges of the joints.
    reached: usize,
    /// Solutions in ranges of all orientations.
    solutions: usize,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let step: f64 = arguments.next().map_or(Ok(0.025), |a| a.parse())?;
    let count: usize = arguments.next().map_or(Ok(200), |a| a.parse())?;
    let path = arguments.next().unwrap_or_else(|| "reachability.ply".into());
    if !(step >= 1e-3 && count >= 1) {
        return Err("the step is at least 0.001 m, and there is at least one orientation".into());
    }

    let orientations = orientations(count);
    let half = (REACH / step).ceil() as i64;
    let line = || (-half..=half).map(|i| i as f64 * step);
    let grid = line().flat_map(|x| line().flat_map(move |y| line().map(move |z| [x, y, z])));
    let places: Vec<[f64; 3]> = grid.filter(|[x, y, z]| x * x + y * y + z * z <= REACH * REACH).collect();

    let style = ProgressStyle::with_template("{bar:40} {percent}% of {len} cells, {eta} left")?;
    let bar = ProgressBar::new(places.len() as u64).with_style(style);
    let start = Instant::now();
    let map = |place: &[f64; 3]| {
        let mut cell = Cell { place: *place, reached: 0, solutions: 0 };
        for orientation in &orientations {
            let target = IsometryMatrix3::from_parts(Translation3::from(*place), *orientation);
            let found = Ur5e.inverse(&target).within_range().len();
            cell.reached += usize::from(found > 0);
            cell.solutions += found;
        }
        cell
    };
    let cells: Vec<Cell> = places.par_iter().progress_with(bar).map(map).collect();
    let seconds = start.elapsed().as_secs_f64();

    let poses = cells.len() * count;
    let solutions: usize = cells.iter().map(|c| c.solutions).sum();
    let (some, all) =
        (cells.iter().filter(|c| c.reached > 0).count(), cells.iter().filter(|c| c.reached == count).count());
    println!(
        "{} cells, {poses} poses, {solutions} solutions in ranges: {seconds:.1} s on {} cores",
        cells.len(),
        rayon::current_num_threads()
    );
    println!("{some} cells are reached with some orientation, {all} with every one");
    write(&path, &cells, count)?;
    println!("written: {path}");
    Ok(())
}

/// Writes the cells behind the plane y = 0 as coloured points.
fn write(path: &str, cells: &[Cell], count: usize) -> std::io::Result<()> {
    let shown: Vec<&Cell> = cells.iter().filter(|c| c.reached > 0 && c.place[1] >= 0.0).collect();
    let mut out = BufWriter::new(File::create(path)?);
    writeln!(
        out,
        "ply\nformat ascii 1.0\ncomment UR5e, share of {count} orientations that are reached\nelement vertex {}",
        shown.len()
    )?;
    writeln!(out, "property float x\nproperty float y\nproperty float z")?;
    writeln!(out, "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header")?;
    for cell in shown {
        let ([x, y, z], share) = (cell.place, cell.reached as f64 / count as f64);
        let level = |from: f64, to: f64| (255.0 * (from + (to - from) * share)).round() as u8;
        let green = (255.0 * (1.0 - (2.0 * share - 1.0).abs())).round() as u8;
        writeln!(out, "{x:.4} {y:.4} {z:.4} {} {green} {}", level(1.0, 0.0), level(0.0, 1.0))?;
    }
    out.flush()
}
