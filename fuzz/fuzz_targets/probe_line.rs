#![no_main]
libfuzzer_sys::fuzz_target!(|data: &[u8]| groundtruth_fuzz::bodies::probe_line::run(data));
