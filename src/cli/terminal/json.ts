import { inEnglish, type Message } from '../../messages/message.ts';

/** Plain data as JSON; its messages are in English, for programs. */
export const toJson = (data: unknown): string =>
  JSON.stringify(data, (_, value) => (isMessage(value) ? inEnglish(value) : value), 2);

const isMessage = (value: unknown): value is Message =>
  typeof value === 'object' && value !== null && 'template' in value && 'values' in value;
