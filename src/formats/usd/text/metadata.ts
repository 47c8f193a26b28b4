import { msg } from '../../../messages/message.ts';
import { InputError } from '../../../scene/types.ts';
import {
  type Dictionary,
  EMPTY_MAP,
  type ListOp,
  type MetadataValue,
  type ReferenceSpec,
  type Value,
  withEntry,
} from '../layer/layer.ts';
import { absolutePath, isPath } from '../layer/paths.ts';
import { Scanner } from './scanner.ts';
import { parseDictionary, parseItems, parseTypeName, parseValue, rawValue } from './values.ts';

const A_TEXT = msg`a text in quotes`;
const METADATA = msg`metadata`;

type Metadata = ReadonlyMap<string, MetadataValue>;

/** Metadata key → value type, for keys registered in OpenUSD (sdf/schema.cpp and the plugInfo of usd, usdGeom, usdShade, usdSkel …). */
const KEY_TYPES: ReadonlyMap<string, string> = new Map(
  Object.entries({
    bool: 'active autoPlay hasOwnedSubLayers hidden instanceable',
    int: 'elementSize framePrecision unauthoredValuesIndex',
    int64: 'arraySizeConstraint',
    float: 'weight',
    double:
      'startTimeCode endTimeCode startFrame endFrame timeCodesPerSecond framesPerSecond metersPerUnit kilogramsPerUnit',
    token:
      'bindMaterialAs colorManagementSystem colorSpace connectability defaultPrim interpolation kind outputName playbackMode renderType upAxis',
    string: 'comment displayGroup displayName documentation owner prefix sessionOwner suffix symmetricPeer',
    'token[]': 'allowedTokens',
    asset: 'colorConfiguration',
    dictionary:
      'assetInfo clips customData customLayerData expressionVariables fallbackPrimTypes limits sdrMetadata symmetryArguments',
  }).flatMap(([type, keys]) => keys.split(' ').map((key): [string, string] => [key, type])),
);

/** Keys that OpenUSD has given up: it keeps their text, as that of unknown keys. */
const FORMER_KEYS: ReadonlySet<string> = new Set(['autoPlay', 'playbackMode']);

export const isFormerKey = (key: string): boolean => FORMER_KEYS.has(key);
/** Whether a schema of OpenUSD knows a key of metadata. */
export const isRegistered = (key: string): boolean => KEY_TYPES.has(key) && !FORMER_KEYS.has(key);

/** Reserved words. */
export const KEYWORDS: ReadonlySet<string> = new Set(
  'add append class config connect custom customData def default delete displayUnit doc inherits kind nameChildren None offset over payload permission prefixSubstitutions prepend properties references rel relocates reorder rootPrims scale specializes subLayers suffixSubstitutions symmetryArguments symmetryFunction timeSamples uniform variantSet variantSets variants varying'.split(
    ' ',
  ),
);

const QUALIFIERS: ReadonlyMap<string, keyof ListOp<unknown>> = new Map([
  ['prepend', 'prepended'],
  ['append', 'appended'],
  ['delete', 'deleted'],
  ['add', 'added'],
  ['reorder', 'ordered'],
]);

/** `prepend`, `append`, `delete`, `add` or `reorder` where a name follows it. */
export function takeQualifier(s: Scanner): keyof ListOp<unknown> {
  const { pos } = s;
  const word = s.peekName();
  const qualifier = word === undefined ? undefined : QUALIFIERS.get(word);
  if (!qualifier) return 'explicit';
  s.takeName();
  if (s.peekName() !== undefined) return qualifier;
  s.pos = pos;
  return 'explicit';
}

/** Parses `[a, b]`, `a` or `None` into the list op under its qualifier; throws for duplicates. */
export function parseListOp<T>(
  s: Scanner,
  op: ListOp<T>,
  qualifier: keyof ListOp<T>,
  item: () => T,
  identity?: (item: T) => string,
): void {
  const items = s.takeKeyword('None') ? [] : s.peek() === '[' ? parseItems(s, item) : [item()];
  if (identity && new Set(items.map(identity)).size < items.length) s.fail(msg`an item of this list is there twice`);
  // An empty prepend or delete is no opinion; an empty explicit list is.
  if (items.length > 0 || qualifier === 'explicit') op[qualifier] = items;
}

/**
 * The `( … )` after a layer's header, a prim's name or a property, where there is one, with what was said `before`.
 * `owner`: path of the prim.
 */
export function parseMetadata(s: Scanner, owner: string, before: Metadata = EMPTY_MAP): Metadata {
  let said = before;
  if (!s.take('(')) return said;
  while (!s.take(')')) {
    if (s.atEnd()) s.expected(msg`')' after metadata`);
    const c = s.peek();
    if (c === '"' || c === "'")
      said = withEntry<MetadataValue>(said, 'comment', { type: 'string', data: s.string(A_TEXT) });
    else said = withEntry(said, ...parseEntry(s, owner, said));
    s.endStatement(METADATA);
  }
  return said;
}

function parseEntry(s: Scanner, owner: string, said: Metadata): [key: string, value: MetadataValue] {
  const qualifier = takeQualifier(s);
  const written = s.joinedName(':', msg`a metadata key or ')'`);
  const key = written === 'doc' ? 'documentation' : written;
  s.expect('=', msg`after the metadata key '${written}'`);
  const special = SPECIAL_PARSERS.get(key);
  const isList = special ? LIST_PARSERS.has(special) : !KEY_TYPES.has(key);
  if (qualifier !== 'explicit' && !isList) s.fail(msg`'${written}' is no list, which could be edited`);
  if (!special && !KEY_TYPES.has(key) && KEYWORDS.has(key))
    s.fail(msg`'${key}' is a word of the language, no metadata key`);
  if (special) return [key, special(s, said.get(key), qualifier, owner)];
  if (qualifier !== 'explicit') return [key, unregisteredList(s, said.get(key), qualifier)];
  return [key, plainEntry(s, key)];
}

function plainEntry(s: Scanner, key: string): Value {
  const type = KEY_TYPES.get(key);
  if (type !== undefined && s.peekName() === 'None') s.expected(msg`a value of type ${type}`);
  if (type === undefined && s.peek() !== '{') return rawValue(s);
  return parseValue(s, type ?? 'dictionary');
}

/** Parses the text of unregistered metadata in a crate. */
export function parseUnregistered(key: string, text: string): Value {
  const s = new Scanner(new TextEncoder().encode(text), key);
  try {
    const value = KEY_TYPES.has(key) ? plainEntry(s, key) : rawValue(s);
    if (s.atEnd()) return value;
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
  }
  return { type: 'unregistered', data: text };
}

/** The same of the items of a list, without its brackets. */
export function parseUnregisteredItems(text: string): Value[] {
  const s = new Scanner(new TextEncoder().encode(`[${text}]`), '');
  try {
    const items = parseItems(s, () => rawValue(s));
    if (s.atEnd()) return items;
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
  }
  return [{ type: 'unregistered', data: text }];
}

function unregisteredList(s: Scanner, old: MetadataValue | undefined, qualifier: keyof ListOp<Value>): MetadataValue {
  const op = old?.type === 'unregistereds' ? old.op : {};
  parseListOp(s, op, qualifier, () => rawValue(s));
  return { type: 'unregistereds', op };
}

type SpecialParser = (
  s: Scanner,
  old: MetadataValue | undefined,
  qualifier: keyof ListOp<unknown>,
  owner: string,
) => MetadataValue;

const arcs: SpecialParser = (s, old, qualifier) => {
  const op = old?.type === 'arcs' ? old.op : {};
  parseListOp(s, op, qualifier, () => parseArc(s), identityOfArc);
  return { type: 'arcs', op };
};
const paths: SpecialParser = (s, old, qualifier, owner) => {
  const op = old?.type === 'paths' ? old.op : {};
  parseListOp(s, op, qualifier, () => parsePath(s, owner, false), String);
  return { type: 'paths', op };
};
const texts: SpecialParser = (s, old, qualifier) => textsOf(s, old, qualifier);
const names: SpecialParser = (s, old, qualifier) => textsOf(s, old, qualifier, String);
const integers: SpecialParser = (s, old, qualifier) => {
  const op = old?.type === 'integers' ? old.op : {};
  parseListOp(s, op, qualifier, () => BigInt(s.integerText().slice(0, 40)));
  return { type: 'integers', op };
};
const tokenValue: SpecialParser = (s) => ({ type: 'token', data: s.takeName() ?? s.string(msg`a name`) });
const permission: SpecialParser = (s) => {
  const data = s.takeName() ?? s.string(msg`public or private`);
  return data === 'public' || data === 'private'
    ? { type: 'token', data }
    : s.fail(msg`'${data}' is not public or private`);
};
const substitutions: SpecialParser = (s) => ({
  type: 'texts-by-name',
  data: new Map(parsePairs(s, () => s.string(A_TEXT))),
});

const SPECIAL_PARSERS: ReadonlyMap<string, SpecialParser> = new Map<string, SpecialParser>([
  ['references', arcs],
  ['payload', arcs],
  ['inherits', paths],
  ['specializes', paths],
  ['apiSchemas', texts],
  ['variantSets', names],
  ['clipSets', texts],
  ['inactiveIds', integers],
  ['permission', permission],
  ['symmetryFunction', tokenValue],
  ['displayUnit', tokenValue],
  ['prefixSubstitutions', substitutions],
  ['suffixSubstitutions', substitutions],
  ['variants', (s) => ({ type: 'texts-by-name', data: parseSelections(s) })],
  ['subLayers', (s) => ({ type: 'subLayers', data: parseItems(s, () => parseArc(s)) })],
  [
    'relocates',
    (s, _old, _qualifier, owner) => ({
      type: 'relocates',
      data: parsePairs(s, () => parsePath(s, owner, false, true)),
    }),
  ],
]);

function textsOf(
  s: Scanner,
  old: MetadataValue | undefined,
  qualifier: keyof ListOp<unknown>,
  identity?: (text: string) => string,
): MetadataValue {
  const op = old?.type === 'texts' ? old.op : {};
  parseListOp(s, op, qualifier, () => s.string(msg`a name in quotes`), identity);
  return { type: 'texts', op };
}

/** Parsers of list ops. */
const LIST_PARSERS: ReadonlySet<SpecialParser> = new Set([arcs, paths, texts, names, integers]);

/** `{ a: b, c: d }` */
function parsePairs(s: Scanner, item: () => string): [string, string][] {
  const pairs: [string, string][] = [];
  s.expect('{', msg`before pairs`);
  while (!s.take('}')) {
    const from = item();
    s.expect(':', msg`between the parts of a pair`);
    pairs.push([from, item()]);
    if (!s.take(',') && s.peek() !== '}') s.expected(msg`',' or '}' after a pair`);
  }
  return pairs;
}

/** `{ string set = "variant" }` */
function parseSelections(s: Scanner): Map<string, string> {
  const selections = new Map<string, string>();
  s.expect('{', msg`before variant selections`);
  while (!s.take('}')) {
    const type = parseTypeName(s);
    if (type !== 'string') s.fail(msg`a variant selection is a string, not a ${type}`);
    const set = s.takeName() ?? s.string(msg`the name of a variant set`);
    s.expect('=', msg`after '${set}'`);
    selections.set(set, s.string(msg`the name of a variant`));
    s.endStatement(msg`the selection of '${set}'`);
  }
  return selections;
}

/** A path as written in the prim `owner`, made absolute. */
export function parsePath(s: Scanner, owner: string, canBeProperty: boolean, canBeNone = false): string {
  s.skip();
  const at = s.pos;
  const path = s.path();
  if (canBeNone && path === '') return '';
  if (!isPath(path, canBeProperty))
    s.fail(
      canBeProperty ? msg`<${path}> is not the path of a prim or a property` : msg`<${path}> is not the path of a prim`,
      at,
    );
  return absolutePath(path, owner);
}

function parseArcPath(s: Scanner): string {
  const at = s.pos;
  const path = s.path();
  if (path !== '' && !(path.startsWith('/') && isPath(path, false)))
    s.fail(msg`<${path}> is not the path of a prim from the root`, at);
  return path;
}

/** Arcs are equal if all parts are. */
const identityOfArc = ({ asset, path, offset, scale, customData }: ReferenceSpec): string =>
  [asset, path, offset, scale, customData ? [...customData.keys()].join() : ''].join('\n');

/** `@file@</Prim> (offset = 1; scale = 2; customData = { … })`, with either part left out. */
function parseArc(s: Scanner): ReferenceSpec {
  s.skip();
  const start = s.pos;
  const asset = s.peek() === '@' ? s.asset() : '';
  if (s.pos > start && asset === '') s.fail(msg`this asset path is empty`, start);
  const path = s.peek() === '<' ? parseArcPath(s) : asset === '' ? s.expected(msg`@file@ or </Prim>`) : '';
  let [offset, scale] = [0, 1];
  let customData: Dictionary | undefined;
  if (s.take('(')) {
    while (!s.take(')')) {
      const key = s.name(msg`offset, scale, customData or ')'`);
      s.expect('=', msg`after '${key}'`);
      if (key === 'offset') offset = s.number();
      else if (key === 'scale') scale = s.number();
      else if (key === 'customData') customData = parseDictionary(s);
      else s.fail(msg`'${key}' is not offset, scale or customData`);
      s.endStatement(`'${key}'`);
    }
  }
  return { asset, path, offset, scale, ...(customData?.size ? { customData } : {}) };
}
