import { msg } from '../../../../messages/message.ts';
import { inputError } from '../../../diagnostics/inputError.ts';
import { type CrateSource, Cursor } from './crateSource.ts';

export const IDENT = 'PXR-USDC';
/** Length of the magic number. */
export const IDENT_BYTES = IDENT.length;
export const HEADER_BYTES = 88;
/** Of the name of a section in the table of contents. */
export const SECTION_NAME_BYTES = 16;
/** Of one entry in the table of contents: its name, where the section begins, how long it is. */
const ENTRY_BYTES = SECTION_NAME_BYTES + 16;
const MAX_SECTIONS = 64;

/** Supported versions: 0.4 (compressed structure) to 0.15 (splines of time codes); array edits, of 0.14, are rejected. */
const [OLDEST, NEWEST] = [4, 15];

export const SECTIONS = ['TOKENS', 'STRINGS', 'FIELDS', 'FIELDSETS', 'PATHS', 'SPECS'] as const;
export type SectionName = (typeof SECTIONS)[number];

export const isCrate = (bytes: Uint8Array): boolean =>
  String.fromCharCode(...bytes.subarray(0, IDENT.length)) === IDENT;

/** Reads the header and the table of contents. Throws for unsupported versions. */
export function readSections(source: CrateSource): Map<SectionName, number> {
  source.section = msg`header`;
  source.require(0, HEADER_BYTES, msg`the header`);
  source.version = checkVersion(source);
  const start = new Cursor(source, 16).i64(msg`the place of the table of contents`);
  source.section = msg`table of contents`;
  const cursor = new Cursor(source, start);
  const count = cursor.count(msg`sections`, ENTRY_BYTES);
  if (count > MAX_SECTIONS) source.fail(msg`it says ${count} sections; a crate file has ${SECTIONS.length}`, start);
  const found = new Map<string, number>();
  for (let i = 0; i < count; i++) {
    const name = nameAt(source, cursor.pass(SECTION_NAME_BYTES, msg`the name of a section`));
    const begin = cursor.i64(msg`the place of section ${name}`);
    source.check(begin, Math.max(0, cursor.i64(msg`the size of section ${name}`)), msg`section ${name}`);
    found.set(name, begin);
  }
  return new Map(
    SECTIONS.map((name) => [name, found.get(name) ?? source.fail(msg`there is no section ${name}`, start)]),
  );
}

function checkVersion({ bytes, base, file }: CrateSource): number {
  const [major, minor, patch] = bytes.subarray(8 - base, 11 - base);
  if (major === 0 && minor >= OLDEST && minor <= NEWEST) return minor;
  const old = major === 0 && minor < OLDEST;
  const what = old
    ? msg`write it anew with a present OpenUSD: usdcat in.usdc -o out.usdc`
    : msg`write it as text: usdcat in.usdc -o out.usda`;
  const read = msg`0.${OLDEST} to 0.${NEWEST} are read`;
  throw inputError('usd.version', file, msg`is a crate file of version ${major}.${minor}.${patch}; ${read}; ${what}`);
}

function nameAt({ bytes, base }: CrateSource, at: number): string {
  const name = bytes.subarray(at - base, at - base + SECTION_NAME_BYTES);
  const end = name.indexOf(0);
  return String.fromCharCode(...(end < 0 ? name : name.subarray(0, end)));
}
