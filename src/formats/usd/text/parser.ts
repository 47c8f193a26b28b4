import { msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import {
  type AttributeSpec,
  EMPTY_MAP,
  type Layer,
  type ListOp,
  type PrimSpec,
  type RelationshipSpec,
  type Specifier,
  type TimeSamples,
  type Value,
  withEntry,
} from '../layer/layer.ts';
import { isPrimName } from '../layer/paths.ts';
import { KEYWORDS, parseListOp, parseMetadata, parsePath, takeQualifier } from './metadata.ts';
import { Scanner } from './scanner.ts';
import { parseSpline } from './splines.ts';
import { parseItems, parseTypeName, parseValue } from './values.ts';

/** Maximum depth of prims and variants. */
export const MAX_DEPTH = 256;

/** Reads a layer of USD text. Throws an InputError that names file, line and column. */
export function parseLayer(bytes: Uint8Array, file: string): Layer {
  const s = new Scanner(bytes, file);
  const header = /^#usda (\d+)\.(\d+)\s*$/.exec(String.fromCharCode(...bytes.subarray(0, 64)).split(/[\r\n]/)[0]);
  if (!header) return s.fail(msg`the file does not begin with '#usda 1.0', so it is not USD text`);
  if (header[1] !== '1')
    throw inputError('usd.version', file, msg`is USD text of version ${header[1]}.${header[2]}; only 1.x is read`);
  const rootPrims = new Map<string, PrimSpec>();
  const layer: Layer = { name: file, metadata: parseMetadata(s, '/'), rootPrims };
  while (!s.atEnd()) {
    if (s.takeKeyword('reorder')) {
      if (!s.takeKeyword('rootPrims')) s.expected("'rootPrims'");
      s.expect('=', msg`after 'reorder rootPrims'`);
      layer.rootOrder = parseNames(s);
    } else rootPrims.set(...parsePrim(s, '', rootPrims, 0));
  }
  return layer;
}

function parseNames(s: Scanner): string[] {
  const name = (): string => s.string(msg`a name in quotes`);
  if (s.peek() !== '[') return [name()];
  const names = parseItems(s, name);
  return names.length > 0 ? names : s.expected(msg`names in the list before this`);
}

/** Parses a prim; returns it with its name. */
function parsePrim(
  s: Scanner,
  parent: string,
  siblings: ReadonlyMap<string, PrimSpec>,
  depth: number,
): [name: string, prim: PrimSpec] {
  if (depth > MAX_DEPTH) s.fail(msg`prims are nested more than ${MAX_DEPTH} deep`);
  const word = s.peekName();
  if (word !== 'def' && word !== 'over' && word !== 'class') s.expected(msg`'def', 'over' or 'class'`);
  s.takeName();
  const typeName = s.peekName() === undefined ? '' : s.joinedName('.', msg`a prim type`);
  if (KEYWORDS.has(typeName)) s.fail(msg`'${typeName}' is a word of the language, no prim type`);
  s.skip();
  const at = s.pos;
  const name = s.string(msg`the name of a prim in quotes`);
  // In a variant the parent's path ends with its selection: /A{set=v}B.
  const path = parent.endsWith('}') ? parent + name : `${parent}/${name}`;
  if (!isPrimName(name)) s.fail(msg`'${name}' is not a prim name`, at);
  if (siblings.has(name)) s.fail(msg`there is already a prim ${path}`, at);
  return [name, parseBody(s, newPrim(path, name, word, typeName), depth)];
}

function newPrim(path: string, name: string, specifier: Specifier, typeName: string): PrimSpec {
  const empty = { metadata: EMPTY_MAP, properties: EMPTY_MAP, children: EMPTY_MAP, variantSets: EMPTY_MAP };
  return { path, name, specifier, typeName, ...empty };
}

/** `( metadata ) { contents }` */
function parseBody(s: Scanner, prim: PrimSpec, depth: number): PrimSpec {
  prim.metadata = parseMetadata(s, prim.path);
  s.expect('{', msg`before the contents of ${prim.path}`);
  while (!s.take('}')) {
    if (s.atEnd()) s.expected(msg`'}' after the contents of ${prim.path}`);
    parseContent(s, prim, depth);
  }
  return prim;
}

function parseContent(s: Scanner, prim: PrimSpec, depth: number): void {
  const word = s.peekName();
  if (word === 'def' || word === 'over' || word === 'class')
    prim.children = withEntry(prim.children, ...parsePrim(s, prim.path, prim.children, depth + 1));
  else if (word === 'variantSet') parseVariantSet(s, prim, depth + 1);
  else if (word === 'reorder' && parseReorder(s, prim)) s.endStatement("'reorder'");
  else parseProperty(s, prim);
}

function parseReorder(s: Scanner, prim: PrimSpec): boolean {
  const { pos } = s;
  s.takeName();
  const what = s.takeName();
  if ((what === 'nameChildren' || what === 'properties') && s.take('=')) {
    if (what === 'properties') prim.propertyOrder = parseNames(s);
    else prim.childOrder = parseNames(s);
    return true;
  }
  s.pos = pos;
  return false;
}

/** `variantSet "set" = { "variant" ( metadata ) { contents } … }` */
function parseVariantSet(s: Scanner, prim: PrimSpec, depth: number): void {
  if (depth > MAX_DEPTH) s.fail(msg`variant sets are nested more than ${MAX_DEPTH} deep`);
  s.takeName();
  const set = s.string(msg`the name of a variant set`);
  s.expect('=', msg`after the variant set '${set}'`);
  s.expect('{', msg`before the variants of '${set}'`);
  let variants = prim.variantSets.get(set) ?? EMPTY_MAP;
  while (!s.take('}')) {
    const name = s.string(msg`the name of a variant of '${set}' or '}'`);
    const variant = parseBody(s, newPrim(`${prim.path}{${set}=${name}}`, name, 'over', ''), depth);
    variants = withEntry(variants, name, variant);
    prim.variantSets = withEntry(prim.variantSets, set, variants);
  }
}

/** `[qualifier] [custom] [uniform | varying] (rel | type[[]]) name …` */
function parseProperty(s: Scanner, prim: PrimSpec): void {
  const qualifier = takeQualifier(s);
  const custom = s.takeKeyword('custom');
  const variability = s.takeKeyword('uniform') ? 'uniform' : s.takeKeyword('varying') ? 'varying' : undefined;
  if (!custom) s.takeKeyword('config');
  if (s.peekName() === undefined) s.expected(msg`a property or '}' in ${prim.path}`);
  if (s.takeKeyword('rel')) parseRelationship(s, prim, qualifier, custom, variability !== 'varying');
  else parseAttribute(s, prim, qualifier, custom, variability === 'uniform');
}

function parseRelationship(
  s: Scanner,
  prim: PrimSpec,
  qualifier: keyof ListOp<string>,
  custom: boolean,
  uniform: boolean,
): void {
  const name = s.joinedName(':', msg`the name of a relationship`);
  const old = prim.properties.get(name);
  if (old && old.kind !== 'relationship') s.fail(msg`'${name}' is already an attribute of ${prim.path}`);
  const rel: RelationshipSpec = old ?? { kind: 'relationship', name, custom, uniform, metadata: EMPTY_MAP };
  prim.properties = withEntry(prim.properties, name, rel);
  if (s.take('=')) {
    rel.targets ??= {};
    parseListOp(s, rel.targets, qualifier, () => parsePath(s, prim.path, true), String);
  }
  rel.metadata = parseMetadata(s, prim.path, rel.metadata);
  s.endStatement(msg`the relationship '${name}'`);
}

function parseAttribute(
  s: Scanner,
  prim: PrimSpec,
  qualifier: keyof ListOp<string>,
  custom: boolean,
  uniform: boolean,
): void {
  const typeName = parseTypeName(s);
  if (KEYWORDS.has(typeName.replace('[]', ''))) s.fail(msg`'${typeName}' is a word of the language, no type`);
  const name = s.joinedName(':', msg`the name of a ${typeName} attribute`);
  const attribute = declare(s, prim, { kind: 'attribute', name, typeName, custom, uniform, metadata: EMPTY_MAP });
  const part = s.take('.') ? s.name(msg`timeSamples, connect or spline`) : '';
  if (qualifier !== 'explicit' && part !== 'connect') s.expected(msg`'.connect' after a list qualifier`);
  if (s.take('=')) parseOpinion(s, prim, attribute, part, qualifier);
  else if (part !== '') s.expected(msg`'=' after '${name}.${part}'`);
  attribute.metadata = parseMetadata(s, prim.path, attribute.metadata);
  s.endStatement(msg`the attribute '${name}'`);
}

/** An attribute may have several statements: its default, samples, connections. */
function declare(s: Scanner, prim: PrimSpec, fresh: AttributeSpec): AttributeSpec {
  const old = prim.properties.get(fresh.name);
  if (old === undefined) {
    prim.properties = withEntry(prim.properties, fresh.name, fresh);
    return fresh;
  }
  if (old.kind !== 'attribute') s.fail(msg`'${fresh.name}' is already a relationship of ${prim.path}`);
  if (old.typeName !== fresh.typeName)
    s.fail(msg`'${fresh.name}' is already of type ${old.typeName}, not ${fresh.typeName}`);
  if (old.uniform !== fresh.uniform) s.fail(msg`'${fresh.name}' is uniform in one statement and not in another`);
  old.custom ||= fresh.custom;
  return old;
}

function parseOpinion(
  s: Scanner,
  prim: PrimSpec,
  attribute: AttributeSpec,
  part: string,
  qualifier: keyof ListOp<string>,
): void {
  switch (part) {
    case '':
      attribute.value = parseValue(s, attribute.typeName);
      break;
    case 'timeSamples':
      attribute.timeSamples = parseTimeSamples(s, attribute.typeName);
      break;
    case 'connect':
      attribute.connections ??= {};
      parseListOp(s, attribute.connections, qualifier, () => parsePath(s, prim.path, true), String);
      break;
    case 'spline':
      attribute.spline = parseSpline(s, attribute.typeName);
      break;
    default:
      s.fail(msg`'.${part}' is not .timeSamples, .connect or .spline`);
  }
}

/** `{ time: value, … }`; of two samples at one time the later stands, as in OpenUSD. */
function parseTimeSamples(s: Scanner, typeName: string): TimeSamples {
  const samples = new Map<number, Value>();
  s.expect('{', msg`before time samples`);
  while (!s.take('}')) {
    const time = s.number();
    if (!Number.isFinite(time)) s.fail(msg`${time} is not a time`);
    s.expect(':', msg`after the time ${time}`);
    samples.set(time, parseValue(s, typeName));
    if (!s.take(',') && s.peek() !== '}') s.expected(msg`',' or '}' after a time sample`);
  }
  const times = Float64Array.from(samples.keys()).sort();
  return { times, values: Array.from(times, (t) => samples.get(t)!) };
}
