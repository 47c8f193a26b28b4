const FIRST = '[\\p{L}_\\u0080-\\uffff]';
const NEXT = '[\\p{L}\\p{N}\\p{M}_\\u0080-\\uffff]';
const PRIM_NAME = new RegExp(`^${FIRST}${NEXT}*$`, 'u');
const PROPERTY_NAME = new RegExp(`^${FIRST}${NEXT}*(:${NEXT}+)*$`, 'u');

export const isPrimName = (name: string): boolean => PRIM_NAME.test(name);
/** Names joined by colons: `primvars:st`. */
export const isPropertyName = (name: string): boolean => PROPERTY_NAME.test(name);

/** `/A{set=variant}B` → `/A/B`: where the prim is in the stage. */
export const withoutVariants = (path: string): string =>
  path
    .replaceAll(/\{[^}]*\}/g, '/')
    .replaceAll(/\/{2,}/g, '/')
    .replace(/(?<=.)\/$/, '');

/** A path as written in the prim `anchor`, made absolute: `../B.x` in `/W/A` is `/W/B.x`. */
export function absolutePath(path: string, anchor: string): string {
  if (path === '' || path.startsWith('/')) return path;
  const parts = withoutVariants(anchor).split('/').filter(Boolean);
  let property = '';
  for (const part of path.split('/')) {
    if (part === '..') parts.pop();
    else if (part.startsWith('.') && part.length > 1) property = part;
    else if (part !== '.') parts.push(part);
  }
  return `/${parts.join('/')}${property}`;
}

/** `/A/B.x` → [`/A/B`, `x`]; the property is empty for the path of a prim. */
export function splitProperty(path: string): readonly [prim: string, property: string] {
  const dot = path.indexOf('.', path.lastIndexOf('/') + 1);
  return dot < 0 ? [path, ''] : [path.slice(0, dot), path.slice(dot + 1)];
}

/** Whether a text is the path of a prim, or of a property where those can be meant; absolute, or from a prim. */
export function isPath(text: string, canBeProperty: boolean): boolean {
  if (text === '.' || text === '/' || /^(\.\.\/)*\.\.$/.test(text)) return canBeProperty || text !== '/';
  const [, above, prim, dot, property] = /^(\/|(?:\.\.\/)*)([^.]*)(\.?)(.*)$/s.exec(text)!;
  if (dot !== '' && !(canBeProperty && isPropertyName(property) && (prim !== '' || above !== '/'))) return false;
  return prim === '' ? dot !== '' : prim.split('/').every(isPrimName);
}
