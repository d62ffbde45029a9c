// What both links refuse of an endpoint before they make it.

import { EndpointKind, ErrorCode, maxHashLength, maxNameLength } from '../protocol/generated/constants.ts';
import type { EndpointDescription } from './link.ts';

const encoder = new TextEncoder();

/** 0, or the ErrorCode of what is wrong with names or kind. */
export function checkDescription({ kind, name, type, hash }: EndpointDescription): number {
  const length = (text: string): number => encoder.encode(text).length;
  const named = length(name);
  if (named === 0 || named > maxNameLength || length(type) > maxNameLength) return ErrorCode.invalidName;
  if (length(hash) > maxHashLength) return ErrorCode.invalidArgument;
  if (kind < EndpointKind.publisher || kind > EndpointKind.server) return ErrorCode.invalidArgument;
  return 0;
}
