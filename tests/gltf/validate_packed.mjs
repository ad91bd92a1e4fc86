// Runs Khronos' validator over GLB files. Prints one line per file, with its errors below; ends
// with status 1 if any file has an error.
//
//   node validate_packed.mjs [--files-missing] FILE.glb...
//
// --files-missing: external files are known to be missing.
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import validator from 'gltf-validator';

const severities = ['errors', 'warnings', 'infos', 'hints'];

const missing = '--files-missing';
const ignoredIssues = process.argv.includes(missing) ? ['IO_ERROR'] : [];

async function validate(path) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(path)), {
    uri: basename(path),
    format: 'glb',
    writeTimestamp: false,
    maxIssues: 100,
    ignoredIssues,
  });
  const { issues } = report;
  const counts = [issues.numErrors, issues.numWarnings, issues.numInfos, issues.numHints];
  console.log(`${basename(path)}: ${counts.map((n, i) => `${n} ${severities[i]}`).join(', ')}`);
  for (const { severity, code, pointer, message } of issues.messages)
    if (severity === 0) console.log(`  ${code} at ${pointer}: ${message}`);
  return issues.numErrors;
}

let errors = 0;
for (const path of process.argv.slice(2).filter((word) => word !== missing)) errors += await validate(path);
process.exit(errors === 0 ? 0 : 1);
