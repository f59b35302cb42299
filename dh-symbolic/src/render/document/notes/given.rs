//! Reads the joint values or the pose that `--example` and its like give for the worked example.

use crate::chain::{AngleCell, Bound, Chain, Coordinate, LengthCell, MotionSpec, Nominal, Role, table};

/// A product of motions, read by the rules and in the unit of a table.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn motions(chain: &Chain, what: &str, text: &str) -> Result<Vec<MotionSpec>, String> {
    table::motions(text, &chain.settings.unit).map_err(|errors| {
        let drawn = errors.draw(text, what);
        let first = drawn.lines().next().unwrap_or_default().trim_start_matches("error: ");
        format!("`{what}` `{text}`: {first}")
    })
}

/// Values of some variables, `q1 = 20deg, q3 = 0.1m`: radians and table units, by joint.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn joints(chain: &Chain, what: &str, text: &str) -> Result<Vec<Option<f64>>, String> {
    let mut values = vec![None; chain.dof()];
    for item in text.split(',').map(str::trim).filter(|t| !t.is_empty()) {
        let Some((name, value)) = item.split_once('=').map(|(n, v)| (n.trim(), v.trim())) else {
            return Err(format!("`{what}` takes values such as `q1 = 20deg`, not `{item}`"));
        };
        let Some(k) = chain.joints.iter().position(|j| j.name == name) else {
            return Err(format!("`{what}`: the robot has no joint variable `{name}`"));
        };
        let revolute = chain.joints.get(k).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
        let list = motions(chain, what, &if revolute { format!("rz({value})") } else { format!("tz({value})") })?;
        let number = match list.as_slice() {
            [MotionSpec::Rotate(_, angle)] => angle.radians(),
            [MotionSpec::Translate(_, x)] => length(x),
            _ => return Err(format!("`{what}` takes values such as `q1 = 20deg`, not `{item}`")),
        };
        if let Some(place) = values.get_mut(k) {
            *place = Some(number);
        }
    }
    Ok(values)
}

/// A length without declared names.
pub(super) fn length(cell: &LengthCell) -> f64 {
    cell.terms.iter().filter(|t| t.1.is_empty()).map(|t| t.0.to_f64()).sum()
}

/// The 4x4 matrix of a motion, upper three rows.
pub(super) fn matrix(motion: &MotionSpec) -> [[f64; 4]; 3] {
    let mut t = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    match motion {
        MotionSpec::Translate(axis, x) => t[axis % 3][3] = length(x),
        MotionSpec::Rotate(axis, angle) => t = turn(*axis, angle.radians()),
        MotionSpec::Pose(_) => {}
    }
    t
}

/// A rotation about a coordinate axis.
pub(super) fn turn(axis: usize, angle: f64) -> [[f64; 4]; 3] {
    let mut t = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    let (s, c) = angle.sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    (t[j][j], t[k][k], t[j][k], t[k][j]) = (c, c, -s, s);
    t
}

/// A bound of a range in radians or table units.
pub(super) fn bound(b: &Bound) -> f64 {
    match b {
        Bound::HalfTurns(x) => x.to_f64() * std::f64::consts::PI,
        Bound::Radians(x) | Bound::Length(x) => x.to_f64(),
    }
}

/// The value of a joint angle's constant part.
pub(super) fn shift(chain: &Chain, cell: &AngleCell) -> f64 {
    let symbol = |(i, k): &(usize, i8)| {
        let value = match chain.parameters.get(*i).map(|p| &p.role) {
            Some(Role::Constant(Nominal::Angle(cell)) | Role::Field(Some(Nominal::Angle(cell)))) => cell.radians(),
            _ => 0.0,
        };
        f64::from(*k) * value
    };
    cell.radians() + cell.symbols.iter().map(symbol).sum::<f64>()
}
