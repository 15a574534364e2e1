//! How a pixel is written, in every command and in the window.

/// `200,150`, perhaps with spaces or parentheses.
///
/// # Errors
/// Says how coordinates are written.
pub fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    let bare = text.trim().trim_start_matches('(').trim_end_matches(')');
    let (x, y) = bare.split_once([',', ' ']).unwrap_or((bare, ""));
    match (x.trim().parse(), y.trim().parse()) {
        (Ok(x), Ok(y)) => Ok([x, y]),
        _ => Err(format!("`{text}` is no pixel; write column and row as 200,150")),
    }
}
