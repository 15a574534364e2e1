//! The colours of drawings.

use space::{Role, ink};

pub const ROLES: [Role; 10] = [
    Role::Incoming,
    Role::Reflected,
    Role::Transmitted,
    Role::Shadow,
    Role::Blocked,
    Role::Dark,
    Role::Normal,
    Role::Outline,
    Role::Surroundings,
    Role::Arc,
];

/// Law: colours are written as `#rrggbb`; no two roles have the same, but for the ray that arrives and the outline; all but the
/// surroundings, which recede, stand out from white by a contrast of 3. Oracle: the contrast of WCAG 2.
#[test]
fn colours_of_roles_differ_and_stand_out() {
    let mut seen: Vec<(&str, Role)> = Vec::new();
    for role in ROLES {
        let color = ink(role);
        let digits = color.strip_prefix('#').unwrap_or_else(|| panic!("{color} of {role:?}"));
        assert_eq!(digits.len(), 6, "digits of the colour of {role:?}");
        let channel = |k: usize| {
            let value = u8::from_str_radix(&digits[2 * k..2 * k + 2], 16).expect("two digits");
            let value = f64::from(value) / 255.0;
            match value <= 0.04045 {
                true => value / 12.92,
                false => groundtruth::math::power((value + 0.055) / 1.055, 2.4),
            }
        };
        let luminance = 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2);
        let contrast = 1.05 / (luminance + 0.05);
        let recedes = contrast < 3.0;
        assert_eq!(recedes, role == Role::Surroundings, "contrast {contrast} of {role:?}");
        let same = seen.iter().find(|(other, _)| *other == color).map(|(_, role)| *role);
        let expected = (role == Role::Outline).then_some(Role::Incoming);
        assert_eq!(same, expected, "a role before {role:?} with the same colour");
        seen.push((color, role));
    }
}
