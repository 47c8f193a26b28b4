import { damagedFiles } from './damagedFiles.ts';
import { seeds } from './seeds.ts';

damagedFiles((await seeds()).filter(({ entry }) => /\.usd[cz]$/.test(entry)));
