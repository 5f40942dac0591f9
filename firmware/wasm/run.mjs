// Runs the cases in WebAssembly: `node run.mjs MODULE STEPS [NAME...]` prints what `desktop` prints.
import { readFileSync } from 'node:fs';

const [path, steps, ...names] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(path), {});
const { case_count, name_byte, case_hash } = instance.exports;
let everyStepWasTaken = true;
for (let number = 0; number < case_count(); number++) {
    let name = '';
    for (let place = 0, byte; (byte = name_byte(number, place)) !== 0; place++) name += String.fromCharCode(byte);
    if (names.length > 0 && !names.includes(name)) continue;
    const marks = [];
    for (let mark = 10; mark < Number(steps); mark *= 10) marks.push(mark);
    for (const done of [...marks, Number(steps)]) {
        const hash = BigInt.asUintN(64, case_hash(number, done));
        everyStepWasTaken &&= hash !== 0n;
        console.log(`${name} ${done} ${hash.toString(16).padStart(16, '0')}`);
    }
}
process.exit(everyStepWasTaken ? 0 : 1);
