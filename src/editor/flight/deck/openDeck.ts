import type { Editor } from '../../state/editor.ts';
import type { ObserverController } from '../observerController.ts';
import { type FlightDeck, flightDeck } from './deck.ts';

/** The deck of the page, with its pilot in charge. */
export function openDeck(editor: Editor, observerController: ObserverController): FlightDeck {
  const deck = flightDeck(editor);
  observerController.pilot = deck.pilot;
  return deck;
}
