import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Comment, parseSync, type Statement } from 'oxc-parser';

export const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

/** What a user of the library imports by name, with its comment. */
export interface PublicExport {
  /** Of `slowlight/ENTRY`. */
  readonly entry: string;
  /** `gamma`, or `vec3.add` in a namespace. */
  readonly name: string;
  /** Only a type: it is not there at run time. */
  readonly isType: boolean;
  readonly file: string;
  readonly line: number;
  /** Its comment without stars; empty if there is none. */
  readonly text: string;
  readonly members: readonly PublicMember[];
}

/** A property or method of an interface or a class. */
interface PublicMember {
  readonly name: string;
  readonly text: string;
}

/** The entries of package.json's `exports`. */
export function entriesOf(): string[] {
  const { exports } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
  return Object.keys(exports).map((path) => path.slice('./'.length));
}

/** What an entry exports. Where each name is declared is found by reading, so that it needs no compiler. */
export function publicApi(entry: string): PublicExport[] {
  const found = exportsOf(join('src', entry, 'index.ts'));
  return [...found].flatMap(([name, place]) => describe(entry, name, place)).sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** A declaration in its file, or a whole file as a namespace. */
type Place = { readonly file: string; readonly statement: Statement } | { readonly namespace: string };

const modules = new Map<string, { text: string; body: Statement[]; comments: Comment[] }>();

function moduleOf(file: string) {
  const known = modules.get(file);
  if (known) return known;
  const text = readFileSync(join(ROOT, file), 'utf8');
  const { program, comments, errors } = parseSync(file, text);
  if (errors.length > 0) throw new Error(`${file}: ${errors[0]!.message}`);
  const module = { text, body: program.body as Statement[], comments };
  modules.set(file, module);
  return module;
}

const nameOf = (node: { type: string; name?: string; value?: unknown }): string => String(node.name ?? node.value);
const fileFrom = (file: string, source: { value: string }): string => join(dirname(file), source.value);

function exportsOf(file: string): Map<string, Place> {
  const found = new Map<string, Place>();
  for (const statement of moduleOf(file).body) {
    if (statement.type === 'ExportAllDeclaration') {
      const from = fileFrom(file, statement.source);
      if (statement.exported) found.set(nameOf(statement.exported), { namespace: from });
      else for (const [name, place] of exportsOf(from)) found.set(name, place);
    } else if (statement.type === 'ExportNamedDeclaration') {
      if (statement.declaration)
        for (const name of declaredIn(statement.declaration)) found.set(name, { file, statement });
      for (const { local, exported } of statement.specifiers)
        found.set(nameOf(exported), placeOf(statement.source ? fileFrom(file, statement.source) : file, nameOf(local)));
    }
  }
  return found;
}

function placeOf(file: string, name: string): Place {
  const exported = exportsOf(file).get(name);
  if (exported) return exported;
  for (const statement of moduleOf(file).body) {
    if (declaredIn(statement).includes(name)) return { file, statement };
    if (statement.type !== 'ImportDeclaration') continue;
    const imported = statement.specifiers.find(({ local }) => local.name === name);
    if (imported?.type === 'ImportSpecifier')
      return placeOf(fileFrom(file, statement.source), nameOf(imported.imported));
  }
  throw new Error(`${file}: ${name} is not declared here`);
}

function declaredIn(statement: Statement): string[] {
  if (statement.type === 'VariableDeclaration')
    return statement.declarations.flatMap(({ id }) => (id.type === 'Identifier' ? [id.name] : []));
  return 'id' in statement && statement.id && 'name' in statement.id ? [statement.id.name as string] : [];
}

function describe(entry: string, name: string, place: Place): PublicExport[] {
  if ('namespace' in place)
    return [...exportsOf(place.namespace)]
      .flatMap(([inner, declared]) => describe(entry, `${name}.${inner}`, declared))
      .filter(({ isType }) => !isType);
  const { file, statement } = place;
  const declared = statement.type === 'ExportNamedDeclaration' ? statement.declaration! : statement;
  return [
    {
      entry,
      name,
      isType: declared.type === 'TSInterfaceDeclaration' || declared.type === 'TSTypeAliasDeclaration',
      file,
      line: moduleOf(file).text.slice(0, statement.start).split('\n').length,
      text: commentBefore(file, statement.start),
      members: membersOf(file, declared),
    },
  ];
}

/** Those that need a sentence: not a literal that tells a type from others, nor what a class's interface explains. */
function membersOf(file: string, declared: Statement): PublicMember[] {
  const members = (list: readonly unknown[]): PublicMember[] =>
    (list as readonly Member[]).flatMap((member) => {
      if (!('key' in member) || member.key.type === 'PrivateIdentifier' || isLiteral(member)) return [];
      if (member.accessibility === 'private' || member.kind === 'constructor') return [];
      return [{ name: nameOf(member.key), text: commentBefore(file, member.start) }];
    });
  if (declared.type === 'TSInterfaceDeclaration') return members(declared.body.body);
  if (declared.type === 'TSTypeAliasDeclaration' && declared.typeAnnotation.type === 'TSTypeLiteral')
    return members(declared.typeAnnotation.members);
  if (declared.type === 'ClassDeclaration' && !declared.implements?.length) return members(declared.body.body);
  return [];
}

interface Member {
  readonly start: number;
  readonly key: { readonly type: string; readonly name?: string };
  readonly kind?: string;
  readonly accessibility?: string;
  readonly typeAnnotation?: { readonly typeAnnotation: { readonly type: string } };
}

const isLiteral = (member: Member): boolean => member.typeAnnotation?.typeAnnotation.type === 'TSLiteralType';

/** The text of the documentation comment that ends before a place. */
function commentBefore(file: string, start: number): string {
  const { text, comments } = moduleOf(file);
  const comment = comments.findLast(({ end }) => end <= start);
  if (comment?.type !== 'Block' || !comment.value.startsWith('*')) return '';
  if (text.slice(comment.end, start).trim() !== '') return '';
  const lines = comment.value.slice(1).split('\n');
  return lines
    .map((line, i) => (i === 0 ? line.trim() : line.replace(/^\s*\* ?/, '').trimEnd()))
    .join('\n')
    .trim();
}
