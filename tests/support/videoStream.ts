import { execFileSync } from 'node:child_process';

/** What ffprobe reads of a film's stream, all its frames counted: `stream,` and the values of these fields in ffprobe's order, as CSV. */
export function videoStream(path: string, fields: string): string {
  const flags = ['-v', 'error', '-count_frames', '-show_entries', `stream=${fields}`, '-of', 'csv'];
  return execFileSync('ffprobe', [...flags, path])
    .toString()
    .trim();
}
