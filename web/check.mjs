// Runs every motion in WebAssembly without a browser, and a user's own body: `node check.mjs MODULE BODY`. The exit code says
// whether each kept its energy, and whether what is no body is refused.
import { readFileSync } from "node:fs";
import { check, load } from "./page/engine.js";

// Of the classical Runge-Kutta method and the linearly implicit one, over a few flips and turns; f32 rounds each step.
const BOUND = { f64: 1e-3, f32: 1e-2 };
const STEPS = 2000;

const [module, body] = process.argv.slice(2);
const engine = await load(readFileSync(module));
let failed = 0;
const refused = (act, expected) => {
  try {
    act();
  } catch (error) {
    if (error.message.includes(expected)) return;
    console.error(`FAILED: expected a message with "${expected}", found "${error.message}"`);
    failed += 1;
    return;
  }
  console.error(`FAILED: expected a refusal with "${expected}"`);
  failed += 1;
};
refused(() => engine.begin({ scene: 2, modes: 0, fidelity: 0, scalar: 0 }), "no body was handed over");
refused(() => engine.read("{}"), "missing field");
refused(() => engine.begin({ scene: 0, modes: 5, fidelity: 0, scalar: 0 }), "no rod of 5 modes");
const modes = engine.read(readFileSync(body, "utf8"));
refused(() => engine.begin({ scene: 2, modes: 9, fidelity: 0, scalar: 0 }), "9");
const lines = check(engine, 3, STEPS, modes);
for (const { scene, modes: count, fidelity, scalar, drift } of lines) {
  const bad = !(drift <= BOUND[scalar]);
  failed += bad;
  console.log(`${bad ? "FAILED" : "ok"} ${scene}, ${count} modes, ${fidelity}, ${scalar}: energy changed by ${drift.toExponential(1)} in ${STEPS} steps`);
}
if (lines.length < 30) {
  console.error(`FAILED: only ${lines.length} motions`);
  failed += 1;
}
process.exit(failed ? 1 : 0);
