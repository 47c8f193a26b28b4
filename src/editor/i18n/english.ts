import { messagesIn } from './messages.ts';

// The build puts the texts themselves here (vite.config.ts), so that the page loads one language.
export const words = messagesIn(0);
