import { damagedFiles } from './damagedFiles.ts';
import { seeds } from './seeds.ts';

damagedFiles((await seeds()).filter(({ entry }) => entry.endsWith('.usda')));
