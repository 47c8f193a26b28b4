import { NAMES } from '../examples/open.ts';
import { compareExamples } from './compareExamples.ts';

compareExamples(NAMES.filter((_, i) => i % 2 === 1));
