import { fuzzSeeds } from './mutatedFiles.ts';
import { seeds } from './seeds.ts';

fuzzSeeds((await seeds()).filter(({ entry }) => !/\.usd.$/.test(entry)));
