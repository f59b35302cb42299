//! Sine, cosine and the error of an angle with about 100 bits, from pairs of doubles (Dekker 1971).

/// A number as an unevaluated sum of two doubles, the second below half an ulp of the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Double {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl Double {
    const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// The exact sum of two doubles.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// The exact product of two doubles.
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }

    fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::sum(high.high, high.low + low.high);
        Self::sum(first.high, first.low + low.low)
    }

    fn times(self, other: Self) -> Self {
        let high = Self::product(self.high, other.high);
        let low = high.low + (self.high * other.low + self.low * other.high);
        Self::sum(high.high, low)
    }

    fn over(self, divisor: f64) -> Self {
        let high = self.high / divisor;
        let rest = Self::product(high, divisor);
        Self::sum(high, (((self.high - rest.high) - rest.low) + self.low) / divisor)
    }

    pub(crate) fn minus(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

/// pi/2 in five parts, four of them of 32 bits, so that products with numbers below 2^20 are exact: 180 bits together.
const PI_2: [f64; 5] =
    [1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21, 8.478427660348229e-32, 2.0670321098263988e-43];

/// Sine and cosine of an angle up to 1e5.
pub(crate) fn sin_cos(x: f64) -> (Double, Double) {
    let n = (x * core::f64::consts::FRAC_2_PI).round();
    // The leading terms cancel exactly; the rest is added from the small end.
    let mut r = Double::sum(x - n * PI_2[0], -n * PI_2[1]);
    for part in &PI_2[2..] {
        r = r.plus(Double { high: -n * part, low: 0.0 });
    }
    let z = r.times(r).minus();
    let (mut sine, mut cosine) = (Double::ZERO, Double::ZERO);
    let one = Double { high: 1.0, low: 0.0 };
    // Taylor series from the far end: 1 - z/2 (1 - z/12 (...)).
    for k in (1..=14).rev() {
        let k = f64::from(k);
        sine = one.plus(sine).times(z).over(2.0 * k * (2.0 * k + 1.0));
        cosine = one.plus(cosine).times(z).over(2.0 * k * (2.0 * k - 1.0));
    }
    let (sine, cosine) = (r.plus(r.times(sine)), one.plus(cosine));
    match n.rem_euclid(4.0) as u8 {
        0 => (sine, cosine),
        1 => (cosine, sine.minus()),
        2 => (sine.minus(), cosine.minus()),
        _ => (cosine.minus(), sine),
    }
}

/// The error of `angle` as the angle of the vector `(x, y)`, in ulp of `angle`.
///
/// The vector turned back by `angle` points along x but for the error.
pub(crate) fn angle_error(angle: f64, y: f64, x: f64) -> f64 {
    // Scaling by a power of two is exact and keeps the products in range.
    let exponent = (x.abs().max(y.abs()).to_bits() >> 52 & 0x7ff) as i32 - 1023;
    let (y, x) = (y * (-exponent as f64 / 2.0).floor().exp2(), x * (-exponent as f64 / 2.0).floor().exp2());
    let (y, x) = (y * (-exponent as f64 / 2.0).ceil().exp2(), x * (-exponent as f64 / 2.0).ceil().exp2());
    let (sine, cosine) = sin_cos(angle);
    let single = |value: f64| Double { high: value, low: 0.0 };
    let across = cosine.times(single(y)).plus(sine.times(single(x)).minus());
    let along = cosine.high * x + sine.high * y;
    let error = across.high.atan2(along);
    let ulp = f64::from_bits(angle.to_bits() & 0x7ff0_0000_0000_0000) * f64::EPSILON;
    (error / ulp).abs()
}
