// The module of WebAssembly as functions that take and give JavaScript's own values.

export const SCENES = [
  { name: "tumbling rod", modes: [0, 2, 4, 8] },
  { name: "slider-crank", modes: [0, 4, 8] },
  { name: "your own body", modes: [0, 1, 2, 3, 4, 6, 8] },
];
export const FIDELITIES = ["full", "linear"];
export const SCALARS = ["f64", "f32"];

export async function load(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const wasm = instance.exports;
  const message = () => {
    const list = [];
    for (let place = 0, byte; (byte = wasm.message_byte(place)) !== 0; place++) list.push(byte);
    return new TextDecoder().decode(Uint8Array.from(list));
  };
  return {
    // An exception says why there is no such motion.
    begin({ scene, modes, fidelity, scalar }) {
      if (wasm.begin(scene, modes, fidelity, scalar) === 0) throw new Error(message());
    },
    // Takes steps; an exception says why one was refused.
    advance(steps) {
      if (wasm.advance(steps) < steps) throw new Error(message());
    },
    stepSize: () => wasm.step_size(),
    energy: () => wasm.energy(),
    // All numbers: for each body position, orientation (x, y, z, w), modal coordinates.
    look() {
      return Float64Array.from({ length: wasm.look() }, (_, place) => wasm.number(place));
    },
    // A body of the user's own: the number of its modes.
    read(text) {
      for (const byte of new TextEncoder().encode(text)) wasm.push_byte(byte);
      const modes = wasm.read_body();
      if (modes < 0) throw new Error(message());
      return modes;
    },
  };
}

// Every motion that there is for so many scenes, a number of steps of each: what became of its energy.
export function check(engine, scenes, steps, most = Infinity) {
  const lines = [];
  for (let scene = 0; scene < scenes; scene++) {
    for (const modes of SCENES[scene].modes.filter((modes) => modes <= most)) {
      for (const fidelity of modes === 0 ? [0] : [0, 1]) {
        for (const scalar of [0, 1]) {
          engine.begin({ scene, modes, fidelity, scalar });
          const before = engine.energy();
          engine.advance(steps);
          const drift = Math.abs(engine.energy() / before - 1);
          lines.push({ scene: SCENES[scene].name, modes, fidelity: FIDELITIES[fidelity], scalar: SCALARS[scalar], drift });
        }
      }
    }
  }
  return lines;
}
