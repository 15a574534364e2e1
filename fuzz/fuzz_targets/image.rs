#![no_main]
libfuzzer_sys::fuzz_target!(|data: &[u8]| groundtruth_fuzz::bodies::image::run(data));
