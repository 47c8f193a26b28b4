#!/usr/bin/env node
import { existsSync } from 'node:fs';

const program = new URL('../dist/lib/cli/main.js', import.meta.url);
if (!existsSync(program)) {
  console.error(
    'slowlight: not built yet. Run `npm run build` in the project folder (or `npm start`, which does it all).',
  );
  process.exit(1);
}
// Who reads only the beginning, as `head` does, has what they wanted.
process.stdout.on('error', (error) => {
  if (error.code !== 'EPIPE') throw error;
  process.exit(0);
});
const { main } = await import(program.href);
process.exitCode = await main(process.argv.slice(2));
