import type { ClaimGroup } from './claim.ts';
import { containerGroups } from './containers.ts';
import { gltfGroups } from './gltf.ts';
import { objGroups } from './obj.ts';
import { panoramaGroups } from './panorama.ts';
import { plyGroups } from './ply.ts';
import { stlGroups } from './stl.ts';
import { usdGroups } from './usd.ts';

/** The claims about one format. */
export interface FormatChapter {
  readonly title: string;
  /** Where to read more. */
  readonly guide?: string;
  readonly groups: readonly ClaimGroup[];
}

export const chapters: readonly FormatChapter[] = [
  { title: 'OpenUSD', guide: 'usd.md', groups: usdGroups },
  { title: 'glTF 2.0', guide: 'gltf.md', groups: gltfGroups },
  { title: 'Wavefront OBJ', guide: 'meshes.md', groups: objGroups },
  { title: 'PLY', guide: 'meshes.md', groups: plyGroups },
  { title: 'STL', guide: 'meshes.md', groups: stlGroups },
  { title: 'Panoramas', guide: 'surroundings.md', groups: panoramaGroups },
  { title: 'Pictures and archives', groups: containerGroups },
];
