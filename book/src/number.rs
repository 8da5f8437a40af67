//! Numbers as a page shows them.

/// How to write a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Whole numbers in full, others to three significant digits.
    Default,
    /// So many significant digits.
    Digits(usize),
    /// So many digits after the point.
    Decimals(usize),
    /// In hundredths, to two significant digits.
    Percent,
    /// As it is.
    Plain,
}

impl Format {
    /// Reads what a page writes after the bar.
    pub fn parse(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<usize>().ok().filter(|&count| count <= 15);
        let digits = text.strip_suffix("digits").or(text.strip_suffix("digit")).and_then(number);
        let decimals = text.strip_suffix("decimals").or(text.strip_suffix("decimal"));
        match (text, digits, decimals.and_then(number)) {
            ("percent", ..) => Ok(Self::Percent),
            ("plain", ..) => Ok(Self::Plain),
            (_, Some(digits @ 1..), _) => Ok(Self::Digits(digits)),
            (_, _, Some(decimals)) => Ok(Self::Decimals(decimals)),
            _ => Err(format!(
                "'{text}' is no format; there are: 3 digits, 2 decimals, percent, plain"
            )),
        }
    }

    /// A number as HTML.
    pub fn write(self, value: f64) -> String {
        let whole = value.fract() == 0.0 && value.abs() < 1e15;
        match self {
            Self::Plain => format!("{value}"),
            Self::Percent => format!("{} %", significant(value * 100.0, 2)),
            Self::Decimals(count) => grouped(&format!("{value:.count$}")),
            Self::Default if whole => grouped(&format!("{value:.0}")),
            Self::Default => significant(value, 3),
            Self::Digits(count) => significant(value, count),
        }
    }
}

/// `value` to so many significant digits; very large and very small ones with a power of ten.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return if value.is_nan() { "not a number" } else { infinity(value) }.into();
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-3..=6).contains(&exponent) {
        let exponent = exponent.to_string().replace('-', "−");
        return format!("{} × 10<sup>{exponent}</sup>", mantissa.replace('-', "−"));
    }
    let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
    // Rounded once, in the shortest form, so that 999.7 to three digits is 1,000.
    let rounded: f64 = scientific.parse().unwrap_or(value);
    grouped(&format!("{rounded:.decimals$}"))
}

fn infinity(value: f64) -> &'static str {
    if value > 0.0 { "∞" } else { "−∞" }
}

/// Digits with a comma at each thousand, and a real minus sign.
fn grouped(digits: &str) -> String {
    let (sign, digits) = digits.strip_prefix('-').map_or(("", digits), |digits| ("−", digits));
    let (whole, fraction) = digits.split_once('.').map_or((digits, None), |(a, b)| (a, Some(b)));
    let mut text = String::from(sign);
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    if let Some(fraction) = fraction {
        text.push('.');
        text += fraction;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Format, significant};

    #[test]
    fn numbers_are_written_for_readers() {
        assert_eq!(Format::Default.write(1_234_567.0), "1,234,567");
        assert_eq!(Format::Default.write(0.123456), "0.123");
        assert_eq!(Format::Default.write(-12.3456), "−12.3");
        assert_eq!(Format::Decimals(1).write(1234.56), "1,234.6");
        assert_eq!(Format::Percent.write(0.03217), "3.2 %");
        assert_eq!(Format::Plain.write(1234.0), "1234");
    }

    #[test]
    fn the_ends_of_the_range_take_a_power_of_ten() {
        assert_eq!(significant(1.25e-7, 2), "1.2 × 10<sup>−7</sup>");
        assert_eq!(significant(4.2e12, 2), "4.2 × 10<sup>12</sup>");
        assert_eq!(significant(999.7, 3), "1,000");
        assert_eq!(significant(0.0, 3), "0");
        assert_eq!(significant(f64::NEG_INFINITY, 3), "−∞");
    }

    #[test]
    fn formats_are_read_and_nonsense_is_refused() {
        assert_eq!(Format::parse("3 digits"), Ok(Format::Digits(3)));
        assert_eq!(Format::parse("0 decimals"), Ok(Format::Decimals(0)));
        assert_eq!(Format::parse("percent"), Ok(Format::Percent));
        for wrong in ["", "0 digits", "digits", "99 digits", "-1 decimals", "three digits"] {
            assert!(Format::parse(wrong).is_err(), "{wrong}");
        }
    }
}
