import { type KeyboardEvent, useState } from 'react';

/** What a NumberInput needs to take a number when it is complete, so that no half-written one reaches the document. */
export function useTypedNumber(number: number, take: (number: number) => void) {
  const [typed, setTyped] = useState<number | string>();
  const commit = () => {
    const value = typeof typed === 'number' ? typed : Number.parseFloat(typed ?? '');
    setTyped(undefined);
    if (Number.isFinite(value)) take(value);
  };
  return {
    value: typed ?? number,
    onChange: setTyped,
    onBlur: commit,
    onKeyDown: (event: KeyboardEvent) => {
      if (event.key === 'Enter') commit();
      if (event.key === 'Escape') setTyped(undefined);
    },
  };
}
