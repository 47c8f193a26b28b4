import type { Registry } from '../graph/nodeType.ts';
import { sceneCamera } from './camera.ts';
import { relativityConsole } from './console.ts';
import { flyNode } from './fly.ts';
import { output } from './output.ts';
import { relativityRasterize } from './rasterize.ts';
import { read } from './read.ts';
import { retimeNode } from './retime.ts';
import { scene } from './scene.ts';
import type { Services } from './services.ts';
import { toneMap } from './toneMap.ts';

const types = [read, retimeNode, scene, relativityConsole, flyNode, sceneCamera, relativityRasterize, toneMap, output];

/** Every node type, by id: a new one is added here and nowhere else. */
export const nodeLibrary: Registry<Services> = Object.fromEntries(types.map((type) => [type.id, type]));
