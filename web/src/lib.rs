//! The library and the gallery in a page: JavaScript writes a question into the module's memory and reads
//! the answer from it; nothing is imported.

mod bits;

use bits::{pixel_bits, scene_names};

/// Memory for a question of so many bytes, which [`answer`] frees.
#[unsafe(no_mangle)]
pub extern "C" fn question(length: usize) -> *mut u8 {
    let buffer = vec![0_u8; length].into_boxed_slice();
    Box::into_raw(buffer).cast()
}

/// Answers a question, `scenes` or `pixels SCENE COUNT SEED`, and frees it. The answer begins with its length
/// (little-endian, four bytes) and is text; a text that begins with `error: ` says what is wrong.
///
/// # Safety
/// `at` and `length` are those of the last [`question`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn answer(at: *mut u8, length: usize) -> *const u8 {
    let bytes = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) };
    let text = String::from_utf8_lossy(&bytes);
    let answer = answered(&text).unwrap_or_else(|error| format!("error: {error}"));
    let length = (answer.len() as u32).to_le_bytes();
    Box::leak([&length[..], answer.as_bytes()].concat().into_boxed_slice()).as_ptr()
}

/// Frees an answer.
///
/// # Safety
/// `at` is what [`answer`] returned, and was not freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn forget(at: *mut u8) {
    unsafe {
        let length =
            u32::from_le_bytes(std::slice::from_raw_parts(at, 4).try_into().expect("four bytes"));
        drop(Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, 4 + length as usize)));
    }
}

fn answered(question: &str) -> Result<String, String> {
    match *question.split_whitespace().collect::<Vec<_>>() {
        ["scenes"] => Ok(scene_names()),
        ["pixels", scene, count, seed] => {
            let number =
                |text: &str| text.parse::<u64>().map_err(|_| format!("`{text}` is no number"));
            let count = number(count)?.try_into().map_err(|_| "too many pixels".to_owned())?;
            pixel_bits(scene, count, number(seed)?)
        }
        _ => Err(format!("`{question}` is no question: `scenes` or `pixels SCENE COUNT SEED`")),
    }
}
