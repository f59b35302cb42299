//! Prints the C++ header (C++17): a class over the functions of C, with arrays, views for batches, and maps for Eigen.

use super::interface::{Interface, Solved};

/// The header.
pub(super) fn text(interface: &Interface<'_>) -> String {
    let (fields, nominal) = (!interface.fields.is_empty(), interface.is_nominal());
    let own = if fields { include_str!("templates/params.hpp.in") } else { "" };
    let constructor = match (fields, nominal) {
        (false, _) => "",
        (true, true) => "    explicit Robot(const Params& params = @name@_nominal()) noexcept : params(params) {}\n\n",
        (true, false) => "    explicit Robot(const Params& params) noexcept : params(params) {}\n\n",
    };
    let solved = interface.inverse.as_ref();
    let part = |text: &'static str| if solved.is_some() { text } else { "" };
    let mut out = include_str!("templates/robot.hpp.in")
        .replace("@params@", own)
        .replace("@constructor@", constructor)
        .replace("@field@", if fields { "    Params params; ///< the parameters of the table\n" } else { "" })
        .replace("@solutions@", part(include_str!("templates/solutions.hpp.in")))
        .replace("@inverse@", part(include_str!("templates/inverse.hpp.in")));
    if let Some(solved) = solved {
        out = of_inverse(&out, solved);
    }
    out.replace("@with@", if fields { "_with" } else { "" })
        .replace("@self@", if fields { "&params, " } else { "" })
        .replace("@order@", if interface.dof() == 1 { "ColMajor" } else { "RowMajor" })
        .replace("@n@", &interface.dof().to_string())
        .replace("@number@", interface.number())
        .replace("@name@", &interface.name)
        .replace("@NAME@", &interface.upper)
}

/// How targets and the joints that are given are passed.
fn of_inverse(text: &str, solved: &Solved) -> String {
    let k = solved.given.len();
    let (take, pass) = match solved.given.as_slice() {
        [] => (String::new(), String::new()),
        [joint] => (format!(", Scalar {joint}"), format!(", {joint}")),
        _ => (", const Given& given".to_string(), ", given.data()".to_string()),
    };
    let list = match k {
        0 => "",
        1 => ", View<const Scalar> given",
        _ => ", View<const Given> given",
    };
    text.replace("@take@", &take)
        .replace("@pass@", &pass)
        .replace("@list@", list)
        .replace(
            "@given_type@",
            &if k > 1 {
                format!("/// Values of the joints that you choose.\nusing Given = std::array<Scalar, {k}>;\n")
            } else {
                String::new()
            },
        )
        .replace("@given_size@", if k == 0 { "" } else { ", given.size()" })
        .replace(
            "@given_data@",
            match k {
                0 => "",
                1 => "given.data(), ",
                _ => "numbers(given), ",
            },
        )
        .replace("@meaning@", solved.meaning)
        .replace("@target_length@", &solved.length.to_string())
}
