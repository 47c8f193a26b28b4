import { exampleTexts } from './exampleTexts.ts';
import { textsIn } from './texts.ts';

// The build replaces this by the texts themselves (vite.config.ts), so that the page loads one language only.
export const words = textsIn(1);
export const examples = exampleTexts;
