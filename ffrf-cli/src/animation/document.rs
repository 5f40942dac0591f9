//! The parts of a glTF file: numbers in one buffer, and the text that says what they are.
//!
//! Source: Khronos Group, glTF 2.0 Specification (2021): 3.6 (buffers), 3.7 (meshes, morph targets), 3.11 (animations), 4
//! (binary form).

use std::collections::BTreeSet;

use ffrf_host::picture::{NamedPoint, Shape};
use serde_json::{Value, json};

use super::frames::BodyFrames;

/// Types of components.
const FLOAT: u32 = 5126;
const UNSIGNED: u32 = 5125;
/// What a part of the buffer is for, where the specification wants it said.
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Colours of bodies, linear red, green, blue.
const COLOURS: [[f32; 3]; 6] = [
    [0.02, 0.17, 0.45],
    [0.66, 0.11, 0.005],
    [0.005, 0.34, 0.17],
    [0.60, 0.19, 0.39],
    [0.09, 0.46, 0.81],
    [0.79, 0.35, 0.01],
];

/// One body of a file.
pub(super) struct Part<'a> {
    pub(super) name: &'a str,
    pub(super) shape: &'a Shape,
    /// What each mode is called.
    pub(super) mode_names: Vec<String>,
    /// Named points with their displacements by each mode.
    pub(super) markers: &'a [NamedPoint],
    /// How it moves, if it does.
    pub(super) motion: Option<&'a BodyFrames>,
}

/// What is said of a whole file.
pub(super) struct Document<'a> {
    pub(super) title: &'a str,
    pub(super) parts: Vec<Part<'a>>,
    /// Times of the frames, if parts move. Units: s.
    pub(super) times: &'a [f32],
    /// Simulated time that passes in one second of the animation.
    pub(super) pace: f64,
    /// Is y up, not z? In the file y always is.
    pub(super) y_is_up: bool,
    /// Factor of the drawn deformation.
    pub(super) deformation: f64,
}

impl Document<'_> {
    /// The bytes of a `.glb` file.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut buffer = Buffer::default();
        let times = (!self.times.is_empty()).then(|| buffer.numbers(self.times, 1, None, true));
        let (mut meshes, mut nodes, mut materials) = (Vec::new(), Vec::new(), Vec::new());
        let (mut samplers, mut channels) = (Vec::new(), Vec::new());
        for (index, part) in self.parts.iter().enumerate() {
            let name = part.name;
            let [red, green, blue] = COLOURS[index % COLOURS.len()];
            materials.push(json!({
                "name": name,
                "doubleSided": true,
                "pbrMetallicRoughness": {"baseColorFactor": [red, green, blue, 1.0], "metallicFactor": 0.1, "roughnessFactor": 0.6},
            }));
            meshes.push(self.mesh(&mut buffer, part, index));
            let markers: Vec<Value> =
                part.markers.iter().map(|marker| self.marker(marker, part.shape)).collect();
            let mut node = json!({"name": name, "mesh": index, "extras": {"markers": markers}});
            if let (Some(moved), Some(times)) = (part.motion, times) {
                node["translation"] = json!(moved.positions.first().copied().unwrap_or_default());
                node["rotation"] = json!(moved.orientations.first().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]));
                let mut animate = |path: &str, output: usize| {
                    channels
                        .push(json!({"sampler": samplers.len(), "target": {"node": index, "path": path}}));
                    samplers.push(json!({"input": times, "output": output, "interpolation": "LINEAR"}));
                };
                animate("translation", buffer.numbers(moved.positions.as_flattened(), 3, None, false));
                animate("rotation", buffer.numbers(moved.orientations.as_flattened(), 4, None, false));
                if !part.shape.modes.is_empty() {
                    animate("weights", buffer.numbers(&moved.weights, 1, None, false));
                }
            }
            nodes.push(node);
        }
        let children: Vec<usize> = (0..nodes.len()).collect();
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let turn = if self.y_is_up { [0.0, 0.0, 0.0, 1.0] } else { [-half, 0.0, 0.0, half] };
        let root = nodes.len();
        nodes.push(json!({"name": "scene", "children": children, "rotation": turn}));
        let mut document = json!({
            "asset": {"version": "2.0", "generator": "ffrf"},
            "extras": {"title": self.title, "pace": self.pace, "deformation": self.deformation},
            "scene": 0,
            "scenes": [{"nodes": [root]}],
            "nodes": nodes,
            "meshes": meshes,
            "materials": materials,
            "accessors": buffer.accessors,
            "bufferViews": buffer.views,
            "buffers": [{"byteLength": buffer.bytes.len()}],
        });
        if !channels.is_empty() {
            document["animations"] =
                json!([{"name": "simulation", "samplers": samplers, "channels": channels}]);
        }
        binary(&document, buffer.bytes)
    }

    fn mesh(&self, buffer: &mut Buffer, part: &Part<'_>, material: usize) -> Value {
        let scaled = |points: &[[f64; 3]], factor: f64| -> Vec<f32> {
            points.iter().flatten().map(|x| (factor * x) as f32).collect()
        };
        let points = buffer.numbers(&scaled(&part.shape.points, 1.0), 3, Some(VERTICES), true);
        let indices = buffer.indices(part.shape.triangles.as_flattened());
        let mut primitive =
            json!({"attributes": {"POSITION": points}, "indices": indices, "material": material, "mode": 4});
        let mut mesh = json!({"name": part.name});
        if !part.shape.modes.is_empty() {
            let targets: Vec<Value> = part
                .shape
                .modes
                .iter()
                .map(|mode| json!({"POSITION": buffer.numbers(&scaled(mode, self.deformation), 3, Some(VERTICES), true)}))
                .collect();
            mesh["weights"] = json!(vec![0.0; targets.len()]);
            mesh["extras"] = json!({"targetNames": part.mode_names});
            primitive["targets"] = json!(targets);
        }
        mesh["primitives"] = json!([primitive]);
        mesh
    }

    /// `held`: the points of the shape that an interface holds.
    fn marker(&self, marker: &NamedPoint, shape: &Shape) -> Value {
        let modes: Vec<[f64; 3]> =
            marker.modes.iter().map(|moved| moved.map(|x| self.deformation * x)).collect();
        let mut value = json!({"name": marker.name, "position": marker.position, "modes": modes});
        if !marker.held.is_empty() {
            let held: BTreeSet<u64> = marker.held.iter().copied().collect();
            let points = shape.nodes.iter().enumerate().filter(|(_, id)| held.contains(id));
            value["held"] = json!(points.map(|(point, _)| point).collect::<Vec<usize>>());
        }
        value
    }
}

/// All numbers of a file.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Adds vectors of `width` components; returns their accessor.
    fn numbers(&mut self, values: &[f32], width: usize, target: Option<u32>, bounds: bool) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        let view = self.view(bytes, target);
        let kind = ["", "SCALAR", "VEC2", "VEC3", "VEC4"][width];
        let mut accessor = json!({
            "bufferView": view, "componentType": FLOAT, "count": values.len() / width, "type": kind,
        });
        if bounds {
            let of = |axis: usize| values.iter().skip(axis).step_by(width).copied();
            let low: Vec<f32> = (0..width).map(|axis| of(axis).fold(f32::INFINITY, f32::min)).collect();
            let high: Vec<f32> = (0..width).map(|axis| of(axis).fold(f32::NEG_INFINITY, f32::max)).collect();
            accessor["min"] = json!(low);
            accessor["max"] = json!(high);
        }
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn indices(&mut self, indices: &[u32]) -> usize {
        let bytes = indices.iter().flat_map(|index| index.to_le_bytes()).collect();
        let view = self.view(bytes, Some(INDICES));
        self.accessors.push(json!({
            "bufferView": view, "componentType": UNSIGNED, "count": indices.len(), "type": "SCALAR",
        }));
        self.accessors.len() - 1
    }

    fn view(&mut self, bytes: Vec<u8>, target: Option<u32>) -> usize {
        let mut view = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.bytes.extend(bytes);
        self.views.push(view);
        self.views.len() - 1
    }
}

/// The binary form: a head, the text, the numbers, each filled up to a multiple of four bytes.
fn binary(document: &Value, mut numbers: Vec<u8>) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    numbers.resize(numbers.len().next_multiple_of(4), 0);
    let total = 12 + 8 + text.len() + 8 + numbers.len();
    let mut file = Vec::with_capacity(total);
    let word = |file: &mut Vec<u8>, value: u32| file.extend_from_slice(&value.to_le_bytes());
    file.extend_from_slice(b"glTF");
    word(&mut file, 2);
    word(&mut file, total as u32);
    word(&mut file, text.len() as u32);
    file.extend_from_slice(b"JSON");
    file.extend(text);
    word(&mut file, numbers.len() as u32);
    file.extend_from_slice(b"BIN\0");
    file.extend(numbers);
    file
}
