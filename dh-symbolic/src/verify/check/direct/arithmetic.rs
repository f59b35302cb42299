//! Sums and products of numbers, angles and matrices at a point.

use super::Direct;
use super::matrix::Rows;

pub(super) fn scaled(q: Direct, k: f64) -> Direct {
    match q {
        Direct::Scalar(x) => Direct::Scalar(k * x),
        Direct::Angle(x) => Direct::Angle(k * x),
        Direct::Matrix(m) => Direct::Matrix(m.scaled(k)),
    }
}

pub(super) fn added(a: Direct, b: Direct) -> Option<Direct> {
    match (a, b) {
        (Direct::Scalar(x), Direct::Scalar(y)) => Some(Direct::Scalar(x + y)),
        (Direct::Matrix(m), Direct::Matrix(n)) if m.columns == n.columns && m.cells.len() == n.cells.len() => {
            let cells = m.cells.iter().zip(&n.cells).map(|(x, y)| x + y).collect();
            Some(Direct::Matrix(Rows { columns: m.columns, cells }))
        }
        (Direct::Angle(x), Direct::Angle(y) | Direct::Scalar(y)) | (Direct::Scalar(x), Direct::Angle(y)) => {
            Some(Direct::Angle(x + y))
        }
        _ => None,
    }
}

pub(super) fn multiplied(a: Direct, b: Direct) -> Option<Direct> {
    match (a, b) {
        (Direct::Scalar(x), Direct::Scalar(y)) | (Direct::Angle(x), Direct::Angle(y)) => Some(Direct::Scalar(x * y)),
        (Direct::Angle(x), Direct::Scalar(y)) | (Direct::Scalar(x), Direct::Angle(y)) => Some(Direct::Angle(x * y)),
        (Direct::Matrix(m), Direct::Scalar(x) | Direct::Angle(x))
        | (Direct::Scalar(x) | Direct::Angle(x), Direct::Matrix(m)) => Some(Direct::Matrix(m.scaled(x))),
        (Direct::Matrix(m), Direct::Matrix(n)) if (m.rows(), m.columns, n.rows(), n.columns) == (4, 4, 3, 1) => {
            Some(Direct::Matrix(m.times(&n.homogeneous())))
        }
        (Direct::Matrix(m), Direct::Matrix(n)) if (m.rows(), n.rows(), n.columns) == (4, 3, 3) => {
            Some(Direct::Matrix(m.rotation()?.times(&n)))
        }
        (Direct::Matrix(m), Direct::Matrix(n)) if (m.rows(), m.columns, n.rows()) == (3, 3, 4) => {
            Some(Direct::Matrix(m.times(&n.rotation()?)))
        }
        (Direct::Matrix(m), Direct::Matrix(n)) => (m.columns == n.rows()).then(|| Direct::Matrix(m.times(&n))),
    }
}
