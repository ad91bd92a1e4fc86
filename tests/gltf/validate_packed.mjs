// Runs Khronos' validator over GLB files. One line a file, the errors below it; ends with status 1
// if any file has an error.
//
//   node validate_packed.mjs FILE.glb...
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import validator from 'gltf-validator';

const severities = ['errors', 'warnings', 'infos', 'hints'];

async function validate(path) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(path)), {
    uri: basename(path),
    format: 'glb',
    writeTimestamp: false,
    maxIssues: 100,
  });
  const { issues } = report;
  const counts = [issues.numErrors, issues.numWarnings, issues.numInfos, issues.numHints];
  console.log(`${basename(path)}: ${counts.map((n, i) => `${n} ${severities[i]}`).join(', ')}`);
  for (const { severity, code, pointer, message } of issues.messages)
    if (severity === 0) console.log(`  ${code} at ${pointer}: ${message}`);
  return issues.numErrors;
}

let errors = 0;
for (const path of process.argv.slice(2)) errors += await validate(path);
process.exit(errors === 0 ? 0 : 1);
