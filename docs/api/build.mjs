// Makes the pages of the library's API in dist/api. `npm run build -- api` runs it; the packages that it needs lie beside it (docs/dependencies.md).
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Application, Converter, PageEvent, ReflectionKind } from 'typedoc';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
const { exports } = JSON.parse(readFileSync(at('../../package.json'), 'utf8'));

const app = await Application.bootstrap({
  name: 'Slowlight',
  entryPoints: Object.keys(exports).map((entry) => at(`../../src/${entry}/index.ts`)),
  tsconfig: at('../../tsconfig.build.json'),
  skipErrorChecking: true,
  readme: at('README.md'),
  out: at('../../dist/api'),
  disableSources: true,
  disableGit: true,
  excludePrivate: true,
  excludeInternal: true,
  githubPages: false,
  hideGenerator: true,
  favicon: at('../../src/app/icon.svg'),
  navigation: { includeFolders: false },
  navigationLinks: { 'The program': '/' },
  sortEntryPoints: false,
  kindSortOrder: ['Namespace', 'Function', 'Class', 'Variable', 'Interface', 'TypeAlias'],
  sort: ['kind', 'instance-first', 'alphabetical-ignoring-documents'],
  groupOrder: ['Namespaces', 'Functions', 'Classes', 'Variables', 'Interfaces', 'Type Aliases'],
  includeHierarchySummary: false,
  // Made by the node library for the renderers, or schemas behind the types of documents.
  intentionallyNotExported: [
    'FastestInScene',
    'FrameGraph',
    'FrameGraphPassOf',
    'LANGUAGE_LIST',
    'ReadFont',
    'RangedFile',
    'RenderStill',
    'SettingValue',
    'BlendedPoints',
    'StreamedPoints',
    'VIEW_LIST',
    'graphShape',
    'paramValueSchema',
  ],
  // Fields are checked by tests/docs/api, which knows which ones need no words.
  requiredToBeDocumented: ['Enum', 'Variable', 'Function', 'Class', 'Interface', 'TypeAlias', 'Namespace', 'Module'],
  validation: { notExported: true, invalidLink: true, notDocumented: true },
});
app.converter.on(Converter.EVENT_RESOLVE_END, ({ project }) => project.children.forEach(addImports));
// The server's content policy allows no scripts within pages; this one only chooses the theme a moment earlier.
// The first page has a title of its own.
app.renderer.on(PageEvent.END, (page) => {
  page.contents = page.contents?.replace(/<script>.*?<\/script>|<h1>Slowlight<\/h1>/gs, '');
});
const project = await app.convert();
if (!project) process.exit(1);
app.validate(project);
await app.generateOutputs(project);
if (app.logger.hasErrors() || app.logger.hasWarnings()) process.exit(1);

/** Begins each example of an entry with the import of what it uses of that entry. */
function addImports(entry) {
  const exported = new Map(entry.children.map((child) => [child.name, child]));
  const visit = (reflection) => {
    const tags = (reflection.comment?.blockTags ?? []).filter(({ tag }) => tag === '@example');
    for (const part of tags.flatMap(({ content }) => content)) {
      if (part.kind !== 'code') continue;
      const taken = new Set(
        [...part.text.matchAll(/^import (?:type )?\{([^}]*)\}/gm)].flatMap(([, names]) => words(names)),
      );
      const code = part.text.replace(/^import .*$|'[^']*'|\/\/.*$/gm, '');
      const names = words(code).filter((name) => exported.has(name) && !taken.has(name));
      if (names.length === 0) continue;
      const imported = [...new Set(names)].sort().map((name) => (isType(exported.get(name)) ? `type ${name}` : name));
      part.text = part.text.replace(/^```ts\n/, `$&import { ${imported.join(', ')} } from '${entry.name}';\n`);
    }
    reflection.traverse((child) => void visit(child));
  };
  visit(entry);
}

function words(text) {
  return text.match(/(?<!\w|(?<!\.\.)\.)[A-Za-z_]\w*/g) ?? [];
}

function isType({ kind }) {
  return kind === ReflectionKind.Interface || kind === ReflectionKind.TypeAlias;
}
