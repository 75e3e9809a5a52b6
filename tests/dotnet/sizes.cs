// The sizes of all structures in bytes. Compiled with GtsMulti.cs.
using System;
using System.Runtime.InteropServices;
using gts;

class Sizes
{
    static void Main()
    {
        foreach (Type type in typeof(mc).GetNestedTypes())
        {
            if (type.IsEnum) continue;
            Console.WriteLine(type.Name + " " + Marshal.SizeOf(type));
        }
    }
}
