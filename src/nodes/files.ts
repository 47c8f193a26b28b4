import { extensionOf } from '../formats/source.ts';
import type { Scene } from '../scene/types.ts';
import { refusal } from './geometry/shared.ts';

/** A file that a project asks for: a description. Who evaluates the project writes it, or offers it. */
export type ProjectFile = SceneFile;

export interface SceneFile {
  readonly kind: 'scene';
  /** Without folders; its extension tells what it is. */
  readonly name: string;
  readonly scene: Scene;
  /** Motions that only this program knows are sampled over the scene’s time, for others to see. */
  readonly sampled: boolean;
}

/** What no system has in the name of a file. */
const ODD = /[\p{Cc}/\\:*?"<>|]/gu;
const LONGEST = 200;

/** A name as a project may give it: a project can be a stranger’s, and is not to choose where on a disk it writes. */
export function fileName(name: string, extensions: readonly string[], node: string): string {
  const plain =
    name ===
    name
      .replace(ODD, '_')
      .replace(/^[.\s]+/u, '')
      .slice(0, LONGEST);
  if (plain && extensions.includes(extensionOf(name))) return name;
  const bare = name
    .replace(/^.*[/\\]/u, '')
    .replace(ODD, '_')
    .replace(/^[.\s]+/u, '')
    .replace(/\.[^.]*$/u, '');
  const value = `${bare.slice(0, LONGEST / 2) || 'file'}.${extensions[0]}`;
  const known = extensions.map((each) => `.${each}`).join(', ');
  const message = `"${name.slice(0, 80)}" is no name of a file without folders that ends in ${known}; write one like ${value}`;
  throw refusal('file.name', `${node}.name`, message, { node, param: 'name', value });
}
