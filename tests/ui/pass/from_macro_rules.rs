//! A table with holes that another macro fills.
macro_rules! planar {
    ($(#[$attribute:meta])* $visibility:vis $name:ident, $convention:ident, $length:expr, $angle:literal) => {
        dh_robot::dh_robot! {
            $(#[$attribute])*
            $visibility struct $name;
            convention = $convention;
            ik = none;
            let l = $length;
            | alpha | a | d | theta | range |
            | 0 | 0 | 0 | q1 | -$angle..=$angle |
            | $angle | l | 0 | q2 | - |
        }
    };
}

planar!(
    /// With two links.
    #[derive(Debug)]
    pub Planar, modified, 2 * 15cm, 30deg
);

fn main() {
    let _ = Planar::default().forward(&[0.0; 2]);
}
