import type { ReactNode } from 'react';
import { useTexts } from '../../language/languageStore.ts';
import type { DisplayValue } from './displayValue.ts';

/** A value as short text, or as its colour. */
export function ValueText({ of }: { readonly of: DisplayValue }): ReactNode {
  const { t } = useTexts();
  if (of.kind === 'text') return t(of.text);
  return <span className="sl-swatch" style={{ background: of.css }} role="img" aria-label={of.css} />;
}
