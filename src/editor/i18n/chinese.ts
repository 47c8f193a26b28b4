import { exampleTexts } from './exampleTexts.ts';
import { textsIn } from './texts.ts';

// The build puts the texts themselves here (vite.config.ts), so that the page loads one language.
export const words = textsIn(1);
export const examples = exampleTexts;
