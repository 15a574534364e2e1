//! The part of Embree 4 that is needed here: triangles, single rays, the first hit. The library is
//! loaded at run time from the path in the environment variable `EMBREE` (see `scripts/peers.sh`).

use std::ffi::{c_char, c_int, c_uint, c_void};
use std::ptr::{null, null_mut};

use groundtruth::math::{Point, Ray};
use libloading::{Library, Symbol};

type Handle = *mut c_void;
type Intersect = unsafe extern "C" fn(Handle, *mut RayHit, *const c_void);

const TRIANGLES: c_int = 0;
const INDICES: c_int = 0;
const VERTICES: c_int = 1;
const UINT3: c_int = 0x5003;
const FLOAT3: c_int = 0x9003;
const ROBUST: c_int = 1 << 2;
const NOTHING: c_uint = c_uint::MAX;

/// `RTCRayHit`, with room for fields that a later version may add.
#[repr(C, align(16))]
struct RayHit {
    origin: [f32; 3],
    near: f32,
    direction: [f32; 3],
    time: f32,
    far: f32,
    mask: c_uint,
    id: c_uint,
    flags: c_uint,
    normal: [f32; 3],
    uv: [f32; 2],
    primitive: c_uint,
    geometry: c_uint,
    instance: [c_uint; 2],
    room: [u32; 11],
}

pub struct Scene {
    _library: Library,
    scene: Handle,
    intersect: Intersect,
    occluded: Intersect,
}

// SAFETY: according to Embree's manual, many threads may query a built scene at once
unsafe impl Sync for Scene {}

/// The first hit of a ray.
pub struct Hit {
    pub t: f64,
    /// Perpendicular to the triangle, of any length.
    pub normal: [f32; 3],
}

impl Scene {
    /// A built scene of one mesh; `None` if there is no library.
    pub fn new(vertices: &[Point], triangles: &[[u32; 3]], robust: bool) -> Option<Self> {
        let path = std::env::var_os("EMBREE")?;
        // SAFETY: the declarations here match `rtcore.h` of Embree 4, and each buffer is filled
        // with as many elements as were requested for it
        unsafe {
            let library = Library::new(path).expect("EMBREE is Embree's shared library");
            let new_device: Symbol<unsafe extern "C" fn(*const c_char) -> Handle> =
                library.get(b"rtcNewDevice").ok()?;
            let new_scene: Symbol<unsafe extern "C" fn(Handle) -> Handle> =
                library.get(b"rtcNewScene").ok()?;
            let set_flags: Symbol<unsafe extern "C" fn(Handle, c_int)> =
                library.get(b"rtcSetSceneFlags").ok()?;
            let new_geometry: Symbol<unsafe extern "C" fn(Handle, c_int) -> Handle> =
                library.get(b"rtcNewGeometry").ok()?;
            let buffer: Symbol<
                unsafe extern "C" fn(Handle, c_int, c_uint, c_int, usize, usize) -> *mut c_void,
            > = library.get(b"rtcSetNewGeometryBuffer").ok()?;
            let commit_geometry: Symbol<unsafe extern "C" fn(Handle)> =
                library.get(b"rtcCommitGeometry").ok()?;
            let attach: Symbol<unsafe extern "C" fn(Handle, Handle) -> c_uint> =
                library.get(b"rtcAttachGeometry").ok()?;
            let commit_scene: Symbol<unsafe extern "C" fn(Handle)> =
                library.get(b"rtcCommitScene").ok()?;
            let intersect: Intersect = *library.get(b"rtcIntersect1").ok()?;
            let occluded: Intersect = *library.get(b"rtcOccluded1").ok()?;

            let device = new_device(null());
            let scene = new_scene(device);
            set_flags(scene, if robust { ROBUST } else { 0 });
            let geometry = new_geometry(device, TRIANGLES);
            let positions =
                buffer(geometry, VERTICES, 0, FLOAT3, 12, vertices.len()).cast::<[f32; 3]>();
            for (i, vertex) in vertices.iter().enumerate() {
                *positions.add(i) = vertex.to_array().map(|x| x as f32);
            }
            let indices =
                buffer(geometry, INDICES, 0, UINT3, 12, triangles.len()).cast::<[u32; 3]>();
            for (i, triangle) in triangles.iter().enumerate() {
                *indices.add(i) = *triangle;
            }
            commit_geometry(geometry);
            attach(scene, geometry);
            commit_scene(scene);
            Some(Self { scene, intersect, occluded, _library: library })
        }
    }

    /// The first hit.
    pub fn hit(&self, ray: &Ray) -> Option<Hit> {
        let mut ray = RayHit::new(ray);
        // SAFETY: the scene is built, and the ray is laid out as the library expects
        unsafe { (self.intersect)(self.scene, &mut ray, null_mut()) };
        let hit = Hit { t: f64::from(ray.far), normal: ray.normal };
        (ray.geometry != NOTHING).then_some(hit)
    }

    /// Whether there is any hit.
    pub fn is_occluded(&self, ray: &Ray) -> bool {
        let mut ray = RayHit::new(ray);
        // SAFETY: as above; the library sets the far end of an occluded ray to −∞
        unsafe { (self.occluded)(self.scene, &mut ray, null_mut()) };
        ray.far < 0.0
    }
}

impl RayHit {
    fn new(ray: &Ray) -> Self {
        Self {
            origin: ray.origin.to_array().map(|x| x as f32),
            near: 0.0,
            direction: ray.direction.to_array().map(|x| x as f32),
            time: 0.0,
            far: f32::INFINITY,
            mask: c_uint::MAX,
            id: 0,
            flags: 0,
            normal: [0.0; 3],
            uv: [0.0; 2],
            primitive: NOTHING,
            geometry: NOTHING,
            instance: [NOTHING; 2],
            room: [0; 11],
        }
    }
}
