//! Every example robot, made by the macro and by its expanded file.

use dh_tests::engine;
use dh_tests::engine::{Engine, invented};

#[allow(dead_code, unreachable_pub)] // the files are as the macro writes them
#[path = "../generated-examples/expanded/mod.rs"]
#[rustfmt::skip]
mod expanded;

/// A robot whose fields have their nominal values, or invented ones where there are none.
macro_rules! robot {
    (pieper, $($path:tt)*) => {
        $($path)* {
            alpha1: invented("alpha1"),
            alpha2: invented("alpha2"),
            alpha3: invented("alpha3"),
            alpha4: invented("alpha4"),
            alpha5: invented("alpha5"),
            a1: invented("a1"),
            a2: invented("a2"),
            a3: invented("a3"),
            d2: invented("d2"),
            d3: invented("d3"),
            d4: invented("d4"),
        }
    };
    ($module:ident, $($path:tt)*) => { <$($path)*>::default() };
}
pub(crate) use robot;

macro_rules! list {
    ($($module:ident $name:ident $dof:literal)*) => {
        /// Name and engines of every robot.
        pub(crate) fn all() -> Vec<(&'static str, [Engine; 2])> {
            vec![$((
                stringify!($module),
                [
                    engine!("the macro", robot!($module, generated_examples::$module::$name), $dof),
                    engine!("the expanded file", robot!($module, expanded::$module::$name), $dof),
                ],
            )),*]
        }
    };
}

generated_examples::for_every_robot!(list);
